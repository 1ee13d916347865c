// Intervals that arise by halving [0,1]. Internal to algebra/.
#pragma once

#include <exsect/algebra/rational.h>

#include <cstdint>

namespace exsect {

/// The interval [index, index + 1] / 2^depth, index < 2^depth.
struct DyadicInterval {
  std::uint64_t index = 0;
  int depth = 0;

  /// The left one, 0, or the right one, 1.
  DyadicInterval half(unsigned which) const { return {2 * index + which, depth + 1}; }
  RationalInterval interval() const {
    return {Rational(index) * power_of_two(-depth), Rational(index + 1) * power_of_two(-depth)};
  }
};

}  // namespace exsect
