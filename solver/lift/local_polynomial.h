// A polynomial of space about a point, in balls. Internal to solver/; docs/method-equations.md,
// section 17.15.
#pragma once

#include <exsect/algebra/ball.h>
#include <exsect/geometry/space_polynomial.h>

#include <array>
#include <vector>

namespace exsect {

/// A box in coordinates w = P - centre.
using SpaceBalls = std::array<DoubleBall, 3>;

/// A positive multiple of f(centre + w). The coefficients are computed exactly and rounded once each, so that
/// nothing cancels, wherever the centre is.
class LocalPolynomial {
 public:
  /// Requires f != 0.
  LocalPolynomial(const SpacePolynomial& f, const Point& centre);

  /// At the centre.
  DoubleBall value() const { return at(0, 0, 0); }
  SpaceBalls gradient() const;
  /// On the box.
  DoubleBall value_on(const SpaceBalls& w) const;
  SpaceBalls gradient_on(const SpaceBalls& w) const;
  /// On the points w = t m + d, |t| <= reach, d in the box: what cancels along the chord does so here
  /// (17.60).
  SpaceBalls gradient_beside(const std::array<double, 3>& m, double reach, const SpaceBalls& d) const;
  /// The coefficients of the polynomial in t with w = t m.
  std::vector<DoubleBall> along(const std::array<double, 3>& m) const;

 private:
  const DoubleBall& at(std::size_t i, std::size_t j, std::size_t k) const {
    return coefficients_[(i * count_ + j) * count_ + k];
  }

  std::size_t count_;  // the degree and 1
  std::vector<DoubleBall> coefficients_;
};

/// A polynomial, constant term first, for |t| <= reach.
DoubleBall values_along(const std::vector<DoubleBall>& f, double reach);

}  // namespace exsect
