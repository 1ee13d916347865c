// Square roots of rational numbers that are rational. Internal to solver/.
#pragma once

#include <exsect/algebra/rational.h>

#include <optional>

namespace exsect {

/// The root that is not negative; empty if q < 0 or the root is irrational.
inline std::optional<Rational> rational_square_root(const Rational& q) {
  if (q < 0) return std::nullopt;
  const Integer above = numerator(q), below = denominator(q);
  const Integer a = sqrt(above), b = sqrt(below);
  if (a * a != above || b * b != below) return std::nullopt;
  return Rational(a) / Rational(b);
}

}  // namespace exsect
