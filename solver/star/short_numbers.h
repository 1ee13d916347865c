// Numbers with few bits for boxes of stars. Internal to solver/.
#pragma once

#include <exsect/algebra/rational.h>

#include <cmath>

namespace exsect {

/// The largest power of two that is at most q > 0, as a double.
inline double power_of_two_below(const Rational& q) {
  double p = std::exp2(std::floor(std::log2(to_double(q))));
  while (from_double(p) > q) {
    p *= 0.5;
  }
  return p;
}

/// A number within room 2^-20 of `at`, with as few bits as that allows, so that faces are short numbers.
inline Rational short_near(const Rational& at, const Rational& room) {
  Rational grid = power_of_two(-52);
  while (grid > room * power_of_two(-20)) {
    grid *= power_of_two(-64);
  }
  const Rational steps = at / grid + Rational(1, 2);
  return grid * Rational(Integer(numerator(steps) / denominator(steps)));
}

}  // namespace exsect
