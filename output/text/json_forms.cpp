#include "output/text/json_forms.h"

#include <exsect/geometry/number.h>

#include <cmath>
#include <limits>

namespace exsect::cli {
namespace {

std::string key_text(const std::string& key) { return Json(key).dump() + ": "; }

/// Length of the text of json without blanks, or anything above `limit` if it is longer than that.
std::size_t length_up_to(const Json& json, std::size_t limit) {
  if (!json.is_structured()) return json.dump().size();
  std::size_t length = 2;
  for (const auto& [key, value] : json.items()) {
    if (length > limit) break;
    length += (json.is_object() ? key_text(key).size() : 1) + length_up_to(value, limit);
  }
  return length;
}

/// Appends json at the given depth; `used` characters stand before it on its line.
void append_text(const Json& json, std::size_t depth, std::size_t used, std::string& text) {
  constexpr std::size_t line = 200;
  if (!json.is_structured() || json.empty() || used + length_up_to(json, line) <= line) {
    text += json.dump();
    return;
  }
  text += json.is_object() ? '{' : '[';
  const char* separator = "\n";
  for (const auto& [key, value] : json.items()) {
    text += separator + std::string(depth + 1, ' ');
    const std::string lead = json.is_object() ? key_text(key) : "";
    text += lead;
    append_text(value, depth + 1, depth + 2 + lead.size(), text);
    separator = ",\n";
  }
  text += "\n" + std::string(depth, ' ') + (json.is_object() ? '}' : ']');
}

}  // namespace

const Rational& shown_width() {
  static const Rational width = power_of_two(-64);
  return width;
}

Json json_number(const Rational& q) { return to_string(q); }

Json json_interval(const RationalInterval& interval) {
  return Json::array({json_number(interval.lower), json_number(interval.upper)});
}

Json json_box(const ParameterBox& box, const ParameterNames& names) {
  Json json = Json::object();
  for (Parameter p : named_parameters(names)) json[name(p, names)] = json_interval(box[index(p)]);
  return json;
}

Json json_approx(const std::array<double, 4>& parameters, const std::array<double, 3>& point,
                 const ParameterNames& names) {
  Json json = Json::object();
  for (Parameter p : named_parameters(names)) json[name(p, names)] = parameters[index(p)];
  json["point"] = point;
  return json;
}

Json json_end(const RealAlgebraic& end, bool closed) {
  return {{"box", json_interval(end.refined_to(shown_width()).interval())},
          {"approx", end.to_double()},
          {"closed", closed}};
}

std::string side_name(Side side, const ParameterNames& names) {
  return std::string(name(side.parameter, names)) + "=" + std::to_string(side.value);
}

double decimal_not_below(double bound) {
  if (!std::isfinite(bound) || bound <= 0) return bound;
  const Rational decimal = parse_number(Json(bound).dump());
  return decimal >= from_double(bound) ? bound
                                       : std::nextafter(bound, std::numeric_limits<double>::infinity());
}

std::string json_text(const Json& json) {
  std::string text;
  append_text(json, 0, 0, text);
  return text + "\n";
}

}  // namespace exsect::cli
