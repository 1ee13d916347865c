#include "certificate/claims.h"

#include <exsect/geometry/number.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace exsect::cli {

std::string in_list(const char* list, std::size_t i) {
  return std::string("$.") + list + "[" + std::to_string(i) + "]";
}

namespace {

/// Appends json.dump(), most of whose strings have nothing to escape, but texts `verbatim` as they stand.
void append(const Json& json, std::string& text) {
  const auto is_plain = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
  if (json.is_object()) {
    char before = '{';
    for (const auto& [key, value] : json.items()) {
      text.append(1, before).append("\"").append(key).append("\":");
      append(value, text);
      before = ',';
    }
    text += json.empty() ? "{}" : "}";
  } else if (json.is_array()) {
    char before = '[';
    for (const Json& value : json) {
      text += before;
      append(value, text);
      before = ',';
    }
    text += json.empty() ? "[]" : "]";
  } else if (json.is_binary()) {
    const auto& bytes = json.get_binary();
    text.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  } else if (const auto* word = json.get_ptr<const std::string*>();
             word && std::all_of(word->begin(), word->end(), is_plain)) {
    text.append("\"").append(*word).append("\"");
  } else {
    text += json.dump();
  }
}

}  // namespace

std::string compact_text(const Json& json) {
  std::string text;
  append(json, text);
  return text;
}

Json verbatim(const std::string& text) {
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  return Json::binary({bytes, bytes + text.size()});
}

Json sealed(const std::string& place, Json claim) {
  std::string text = place;
  append(claim, text);
  claim["seal"] = checker::seal(text);
  return claim;
}

namespace {

void append_integer(std::string& text, std::int64_t n) {
  const fmt::format_int digits(n);
  text.append(digits.data(), digits.size());
}

}  // namespace

void append_number(std::string& text, double a) {
  if (a == 0 || !(std::abs(a) < 0x1p53)) {
    text += to_string(from_double(a));
    return;
  }
  int exponent = 0;  // a = p 2^(exponent - 53); with q = 2^halvings, p/q in lowest terms
  const auto p = static_cast<std::int64_t>(0x1p53 * std::frexp(a, &exponent));
  const int even = std::min(53 - exponent, std::countr_zero(static_cast<std::uint64_t>(p)));
  const int halvings = 53 - exponent - even;
  append_integer(text, p >> even);
  if (halvings == 0) return;
  text += halvings < 8 ? "/" : "/2^";
  append_integer(text, halvings < 8 ? 1 << halvings : halvings);
}

std::string exact_number(double a) {
  std::string result;
  append_number(result, a);
  return result;
}

Json exact_numbers(const std::vector<double>& numbers) {
  Json result = Json::array();
  for (const double a : numbers) result.push_back(exact_number(a));
  return result;
}

const char* letter(std::size_t parameter) { return name(all_parameters[parameter]); }

namespace {

Json weights(const RationalPatch& patch) {
  Json result = Json::array();
  for (int i = 0; i <= patch.degree_u(); ++i) {
    Json row = Json::array();
    for (int j = 0; j <= patch.degree_v(); ++j) row.push_back(to_string(patch.weight(i, j)));
    result.push_back(row);
  }
  return result;
}

}  // namespace

Json patch_claim(const std::string& place, const std::string& name, const RationalPatch& patch) {
  Json points = Json::array();
  for (int i = 0; i <= patch.degree_u(); ++i) {
    Json row = Json::array();
    for (int j = 0; j <= patch.degree_v(); ++j) row.push_back(rationals(patch.point(i, j)));
    points.push_back(row);
  }
  if (!patch.is_polynomial())
    return sealed(place, {{"name", name}, {"points", points}, {"weights", weights(patch)}});
  return sealed(place, {{"name", name}, {"points", points}});
}

Json equation_claim(const std::string& place, const std::string& name, const SpacePolynomial& f) {
  Json terms = Json::array();
  for (const auto& [power, c] : f.terms()) terms.push_back({to_string(c), power[0], power[1], power[2]});
  return sealed(place, {{"name", name}, {"equation", terms}});
}

std::string map_text(const checker::MapName& map) {
  if (map.chart == Chart::star)
    return "star" + std::to_string(map.star) + letter(map.direction / 2) + "+-"[map.direction % 2];
  return map.chart == Chart::pair ? "pair" : map.chart == Chart::first ? "first" : "second";
}

namespace {

/// What the tube's curve is.
std::string curve(const Tube& tube) {
  if (tube.factor < 0) return map_text(tube);
  return (tube.chart == Chart::star ? map_text(tube) : "") + "factor" + std::to_string(tube.factor);
}

}  // namespace

Json tube_claims(const NearPair& pair, const std::vector<Tube>& tubes) {
  Json result = Json::array();
  for (const Tube& t : tubes) {
    Json rows = Json::array();
    for (auto row : t.inverse) {
      for (std::size_t d = 0; d < 3; ++d)
        row[d] /= t.chart == Chart::star || t.factor >= 0 ? 1 : pair.scale[d];
      rows.push_back(exact(row));
    }
    result.push_back(sealed(in_list("tubes", result.size()), {{"centre", exact(t.centre)},
                                                              {"axis", letter(t.axis)},
                                                              {"slope", exact(t.slope)},
                                                              {"reach", exact_number(t.reach)},
                                                              {"width", exact_number(t.width)},
                                                              {"inverse", rows},
                                                              {"curve", curve(t)}}));
  }
  return result;
}

Json cover_claims(const std::vector<std::string>& entries) {
  constexpr std::size_t row = 100;
  Json result = Json::array();
  for (std::size_t i = 0; i < entries.size(); i += row) {
    std::string text = entries[i];
    for (std::size_t j = i + 1; j < std::min(i + row, entries.size()); ++j) text += " " + entries[j];
    result.push_back(text + " #" + checker::seal(in_list("cover", result.size()) + text));
  }
  return result;
}

std::string claims_text(const Json& document) {
  std::string result = "{";
  for (const auto& [key, value] : document.items()) {
    result += (result.size() == 1 ? "" : ",\n ") + Json(key).dump() + ": ";
    if (!value.is_array() || value.empty()) {
      append(value, result);
      continue;
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      result += i == 0 ? "[\n  " : ",\n  ";
      append(value[i], result);
    }
    result += "]";
  }
  return result + "}\n";
}

NoCertificate not_accepted(const checker::Rejected& rejected) {
  return NoCertificate("a claim that is not accepted: " + rejected.place() + ": " + rejected.what());
}

namespace {

/// A number of ten bits that is by an eighth or more above `needed`: another check's enclosures may be wider.
double clearly_above(double needed) {
  int exponent = 0;
  const double mantissa = std::frexp(needed * 1.125, &exponent);
  return std::ldexp(std::ceil(mantissa * 1024), exponent - 10);
}

/// Arcs, and edges of overlaps, whose error bounds the check, with enclosures of its own, cannot confirm get
/// ones that it can.
void enlarge_bound(Json& document, const checker::Shortfall& shortfall) {
  const double enough = clearly_above(shortfall.needed);
  if (!std::isfinite(enough)) throw NoCertificate("an arc whose polyline's error bound cannot be confirmed");
  const char* const list = shortfall.overlap ? "overlaps" : "arcs";
  const std::size_t i = shortfall.overlap.value_or(shortfall.arc);
  Json claim = document[list][i];
  claim.erase("seal");
  (shortfall.overlap ? claim["edges"][shortfall.arc] : claim)["error_bound"] = exact_number(enough);
  document[list][i] = sealed(in_list(list, i), claim);
}

}  // namespace

std::string accepted_text(Json document) {
  const std::string certificate = claims_text(document);
  try {
    const std::vector<checker::Shortfall> shortfalls = checker::too_small_error_bounds(certificate);
    if (shortfalls.empty()) return certificate;
    for (const checker::Shortfall& shortfall : shortfalls) enlarge_bound(document, shortfall);
    return claims_text(document);
  } catch (const checker::Rejected& rejected) {
    throw not_accepted(rejected);
  }
}

std::string confirmed(const std::string& certificate) {
  try {
    checker::check_certificate(certificate);
    return certificate;
  } catch (const checker::Rejected& rejected) {
    throw not_accepted(rejected);
  }
}

}  // namespace exsect::cli
