#include "output/text/terminal_text.h"

#include <exsect/geometry/number.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace exsect::cli {

std::string printable(const std::string& text) {
  std::string plain = text;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const auto byte = static_cast<unsigned char>(plain[i]);
    const bool second_control = byte == 0xC2 && i + 1 < plain.size() &&
                                static_cast<unsigned char>(plain[i + 1]) < 0xA0;  // U+0080 to U+009F
    if (byte < 0x20 || byte == 0x7F) plain[i] = ' ';
    if (second_control) plain.replace(i, 2, " ");
  }
  return plain;
}

std::string decimal(double x) { return fmt::format("{:.12f}", x); }

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

std::string interval_text(const RationalInterval& interval) {
  const double lower = std::floor(to_double(interval.lower) * 1e6) / 1e6;
  const double upper = std::ceil(to_double(interval.upper) * 1e6) / 1e6;
  return fmt::format("[{}, {}]", lower, upper);
}

std::string box_text(const ParameterBox& box, const ParameterNames& names) {
  std::vector<std::string> ranges;
  for (Parameter p : all_parameters)
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
