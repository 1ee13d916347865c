// Rational Bézier curves of the plane and of space with exact control points and positive weights.
#pragma once

#include <exsect/algebra/polynomial.h>

#include <vector>

namespace exsect {

/// p(t) = sum_i B_i^n(t) w_i P_i / sum_i B_i^n(t) w_i over t in [0,1]. Invariant: degree n >= 1, n+1 control
/// points of one dimension, 2 or 3, and n+1 weights > 0. Immutable.
class BezierCurve {
 public:
  /// No weights: all are 1. Throws std::invalid_argument, naming the statement, if the invariant is violated.
  explicit BezierCurve(std::vector<std::vector<Rational>> points, std::vector<Rational> weights = {});

  int degree() const { return static_cast<int>(points_.size()) - 1; }
  int dimension() const { return static_cast<int>(points_.front().size()); }
  const std::vector<std::vector<Rational>>& points() const { return points_; }
  const std::vector<Rational>& weights() const { return weights_; }
  /// All weights are equal.
  bool is_polynomial() const;
  /// All control points are equal: the curve is one point.
  bool is_point() const;

  /// The value at any rational t where the denominator does not vanish, in [0,1] or not; std::domain_error
  /// where it does.
  std::vector<Rational> operator()(const Rational& t) const;

  /// The planar curve of the coordinates i and j (0-based); std::invalid_argument beyond the dimension.
  BezierCurve projected(int i, int j) const;
  /// t -> p(1 - t).
  BezierCurve reversed() const;

  friend bool operator==(const BezierCurve& a, const BezierCurve& b) = default;

 private:
  std::vector<std::vector<Rational>> points_;
  std::vector<Rational> weights_;
};

/// The curve as p(t) = (numerators)/denominator. Invariant: no factor is common to all, and the denominator
/// is positive on [0,1]; it is 1 for a polynomial curve.
struct HomogeneousCurve {
  std::vector<Polynomial> numerators;
  Polynomial denominator;

  /// Largest degree of the polynomials.
  int degree() const;
};

/// Common factors of all coordinates removed.
HomogeneousCurve homogeneous(const BezierCurve& curve);

}  // namespace exsect
