// The quadratic functions that map [0,1] onto itself. Internal to solver/; docs/method.md, section 6.7.
#pragma once

#include <exsect/algebra/rational.h>

#include <vector>

namespace exsect {

/// q(r) = 2 t r + (1 - 2 t) r² with 0 <= t < 1/2, strictly increasing on [0,1] (6.6).
class MonotoneQuadratic {
 public:
  /// Throws std::invalid_argument for another t.
  explicit MonotoneQuadratic(const Rational& t);

  Rational operator()(const Rational& r) const;
  /// Its derivative at 0 vanishes.
  bool starts_at_turn() const { return t_ == 0; }
  /// The r in [0,1] with q(r) = q, for q in [0,1], rounded.
  double inverse(double q) const;
  /// Enclosures of the preimages of closed intervals in [0,1]. Ends that are preimages of different numbers,
  /// also of 0 and 1, are different and in the same order: what was disjoint remains so. 0, 1 and rational
  /// preimages are exact.
  std::vector<RationalInterval> inverse(const std::vector<RationalInterval>& intervals) const;

 private:
  RationalInterval enclosed_inverse(const Rational& q, long bits) const;

  Rational t_;
  double t_rounded_;
};

}  // namespace exsect
