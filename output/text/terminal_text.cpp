#include "output/text/terminal_text.h"

#include <exsect/geometry/number.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/text/proved_decimal.h"

namespace exsect::cli {
namespace {

/// A code point of Unicode and the number of bytes it takes; 0 and one byte where the bytes are no UTF-8.
struct Character {
  char32_t code;
  std::size_t bytes;
};

Character character_at(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(at);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || at + bytes > text.size()) return {0, 1};
  char32_t code = lead & (0xFFU >> (bytes + 1));
  for (std::size_t i = at + 1; i < at + bytes; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return {0, 1};
    code = code << 6U | (byte(i) & 0x3FU);
  }
  constexpr char32_t least[] = {0x80, 0x800, 0x10000};
  if (code < least[bytes - 2] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return {0, 1};
  return {code, bytes};
}

/// Whether a terminal obeys the character instead of showing it.
bool steers(char32_t c) {
  const bool control = c < 0x20 || (c >= 0x7F && c < 0xA0);
  const bool separator = c == 0x2028 || c == 0x2029;
  const bool mark = c == 0x061C || c == 0x200E || c == 0x200F;
  const bool embedding_or_override = c >= 0x202A && c <= 0x202E;
  const bool isolate = c >= 0x2066 && c <= 0x2069;
  return control || separator || mark || embedding_or_override || isolate;
}

}  // namespace

std::string printable(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    const Character character = character_at(text, i);
    if (steers(character.code))
      plain += ' ';
    else
      plain.append(text, i, character.bytes);
    i += character.bytes;
  }
  return plain;
}

std::string rounded_up(double x) {
  if (!std::isfinite(x)) return fmt::format("{}", x);
  const std::string nearest = fmt::format("{:.2e}", x);
  if (parse_number(nearest) >= from_double(x)) return nearest;
  // "d.dde+xx": one more unit of the last digit.
  int digits = std::stoi(nearest.substr(0, 1) + nearest.substr(2, 2)) + 1;
  int exponent = std::stoi(nearest.substr(nearest.find('e') + 1));
  if (digits == 1000) {
    digits = 100;
    ++exponent;
  }
  return fmt::format("{}.{:02d}e{:+03d}", digits / 100, digits % 100, exponent);
}

std::string joined(const std::vector<std::string>& texts, const std::string& separator) {
  if (texts.empty()) return "-";
  return fmt::format("{}", fmt::join(texts, separator));
}

std::string interval_text(const RationalInterval& interval) { return outward_decimal(interval, -6); }

std::string box_text(const ParameterBox& box, const ParameterNames& names) {
  std::vector<std::string> ranges;
  for (Parameter p : named_parameters(names))
    ranges.push_back(fmt::format("{} in {}", name(p, names), interval_text(box[index(p)])));
  return joined(ranges, ", ");
}

std::string counted(std::size_t number, const std::string& noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

std::string heading(const std::string& file, const std::string& title) {
  return printable(file) + (title.empty() ? "" : ": " + printable(title)) + "\n";
}

std::string table(const std::vector<std::string>& heads, const std::vector<std::vector<std::string>>& rows) {
  if (rows.empty()) return "";
  std::vector<std::size_t> widths;
  for (const std::string& head : heads) widths.push_back(head.size());
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) text += fmt::format("  {:<{}}", cells[i], widths[i]);
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
  };
  std::string text = line(heads);
  for (const auto& row : rows) text += line(row);
  return text;
}

}  // namespace exsect::cli
