// Power series of two numbers with a bound of what is left out. Internal to solver/; docs/method-doubles.md,
// section 14.26.
#pragma once

#include <exsect/algebra/rational.h>

#include <optional>
#include <vector>

namespace exsect::filter {

/// base^n, n >= 0.
Rational power(const Rational& base, int n);

/// A function f of p and q, analytic for complex |p|, |q| <= reach, with
/// |f - sum c_ij p^i q^j| <= rest max(|p|,|q|)^(order+1), the sum over i + j <= order, (14.121).
class PlaneSeries {
 public:
  /// Zero. Requires order >= 0, reach > 0.
  PlaneSeries(int order, Rational reach);
  /// p^i q^j. Requires i + j <= order.
  static PlaneSeries power(int order, const Rational& reach, int i, int j);

  int order() const { return order_; }
  const Rational& reach() const { return reach_; }
  const Rational& rest() const { return rest_; }
  /// Requires i, j >= 0, i + j <= order().
  const Rational& coefficient(int i, int j) const { return c_[index(i, j)]; }
  bool is_polynomial_zero() const;
  /// >= |f| for all p and q.
  Rational size() const;

  /// With the rest 0: the polynomial alone, for another order, which may leave out terms, and reach.
  PlaneSeries polynomial(int order, const Rational& reach) const;
  /// Adds every function with |f| <= rest max(|p|,|q|)^(order+1).
  void widen(const Rational& rest) { rest_ += rest; }
  /// Adds factor times the other one, of the same order and reach.
  void add(const PlaneSeries& other, const Rational& factor);
  /// f / (p^i q^j), (14.128), if the terms up to order() have these powers and order() >= i + j. Requires
  /// that this is analytic.
  std::optional<PlaneSeries> divided(int i, int j) const;
  /// Requires the same order and reach.
  friend PlaneSeries operator*(const PlaneSeries& a, const PlaneSeries& b);

 private:
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(i * (order_ + 1) + j); }
  Rational polynomial_size() const;

  int order_;
  Rational reach_;
  std::vector<Rational> c_;
  Rational rest_ = 0;
};

}  // namespace exsect::filter
