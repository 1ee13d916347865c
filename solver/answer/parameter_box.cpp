#include "answer/parameter_box.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace exsect {

RationalInterval hull(const RationalInterval& a, const RationalInterval& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

ParameterBox hull(const ParameterBox& a, const ParameterBox& b) {
  ParameterBox result;
  for (std::size_t j = 0; j < result.size(); ++j) result[j] = hull(a[j], b[j]);
  return result;
}

Rational simplest_near(const RationalInterval& at, const Rational& room) {
  return at.width() == 0 ? at.lower : simplest_between(at.lower - room, at.upper + room);
}

RationalInterval reversed(const RationalInterval& at) { return {1 - at.upper, 1 - at.lower}; }

bool is_in(const RealAlgebraic& value, const RationalInterval& range) {
  return value.compare(range.lower) >= 0 && value.compare(range.upper) <= 0;
}

bool meet(const ParameterBox& a, const ParameterBox& b) {
  for (std::size_t j = 0; j < a.size(); ++j)
    if (a[j].upper < b[j].lower || b[j].upper < a[j].lower) return false;
  return true;
}

bool meets_side(const ParameterBox& box, std::size_t fixed, int value) {
  return std::ranges::any_of(std::array{fixed, fixed + 2},
                             [&](std::size_t j) { return box[j].lower <= value && value <= box[j].upper; });
}

bool lies_in(const ParameterBox& inner, const ParameterBox& outer) {
  for (std::size_t j = 0; j < inner.size(); ++j)
    if (inner[j].lower < outer[j].lower || inner[j].upper > outer[j].upper) return false;
  return true;
}

Rational gap(const RationalInterval& a, const RationalInterval& b) {
  return std::max<Rational>({a.lower - b.upper, b.lower - a.upper, 0});
}

Rational distance(const ParameterBox& a, const ParameterBox& b) {
  Rational result = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    result = std::max(result, gap(a[j], b[j]));
  }
  return result;
}

ParameterBox whole_domain() { return {{{0, 1}, {0, 1}, {0, 1}, {0, 1}}}; }

ParameterBox around(const std::array<double, 4>& where) {
  ParameterBox box;
  for (std::size_t j = 0; j < 4; ++j) {
    const Rational centre = from_double(std::isfinite(where[j]) ? std::clamp(where[j], 0.0, 1.0) : 0.5);
    box[j] = {std::max<Rational>(centre - power_of_two(-20), 0),
              std::min<Rational>(centre + power_of_two(-20), 1)};
  }
  return box;
}

}  // namespace exsect
