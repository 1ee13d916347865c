// Pairs of points of a common surface, given in different rectangles of its parameters. Internal to solver/.
#pragma once

#include <exsect/solver/parameter.h>

#include <algorithm>
#include <array>

#include "shape/shifted_copy.h"

namespace exsect {

/// t -> outer^-1(inner(t))
inline AffineMap quotient(const AffineMap& outer, const AffineMap& inner) {
  return {(inner.offset - outer.offset) / outer.factor, inner.factor / outer.factor};
}

/// Pairs of points of a rectangle of the (u,v) plane, each given in [0,1]², as (u,v,r,s).
class PairMap {
 public:
  PairMap(const ShiftedCopy& copy, const std::array<AffineMap, 2>& rectangle)
      : maps_({rectangle[0], rectangle[1], quotient(copy.maps[0], rectangle[0]),
               quotient(copy.maps[1], rectangle[1])}) {}

  std::array<double, 4> operator()(const std::array<double, 4>& pair) const {
    std::array<double, 4> result{};
    for (std::size_t j = 0; j < 4; ++j) {
      const double value = to_double(maps_[j].offset) + to_double(maps_[j].factor) * pair[j];
      result[j] = std::clamp(value, 0.0, 1.0);
    }
    return result;
  }

  RationalInterval operator()(const RationalInterval& interval, std::size_t j) const {
    const Rational a = maps_[j](interval.lower);
    const Rational b = maps_[j](interval.upper);
    return {std::min(a, b), std::max(a, b)};
  }

 private:
  std::array<AffineMap, 4> maps_;
};

}  // namespace exsect
