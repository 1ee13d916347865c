#include "shape/coincident_parameters.h"

#include <exsect/algebra/real_algebraic.h>

#include <algorithm>
#include <vector>

#include "shape/planar_patch.h"

namespace exsect {

namespace {

/// X_a W - X W_a for a patch x = X/W and a parameter a: W² times the derivative of x, three polynomials.
using DerivativeVector = std::array<BivariatePolynomial, 3>;

DerivativeVector derivative_by(const RationalPatch& x, std::size_t parameter) {
  const auto by = [&](const BivariatePolynomial& f) {
    return parameter == 0 ? f.derivative_r() : f.derivative_s();
  };
  const BivariatePolynomial weight = x.component(3);
  DerivativeVector result;
  for (int k = 0; k < 3; ++k) {
    const BivariatePolynomial part = x.component(k);
    result[static_cast<std::size_t>(k)] = by(part) * weight - part * by(weight);
  }
  return result;
}

/// The vectors that a linear form must annihilate to be independent of the parameter of the derivative.
void append_constraints(std::vector<Point>& constraints, const DerivativeVector& d) {
  for (int i = 0; i <= std::max({d[0].degree_r(), d[1].degree_r(), d[2].degree_r()}); ++i) {
    for (int j = 0; j <= std::max({d[0].degree_s(), d[1].degree_s(), d[2].degree_s()}); ++j) {
      const Point c = {d[0].coefficient(i, j), d[1].coefficient(i, j), d[2].coefficient(i, j)};
      if (!is_zero(c)) constraints.push_back(c);
    }
  }
}

/// The form is a function of the parameter alone. Whether its derivative is zero at 0 and at 1; empty if it
/// is elsewhere in [0,1].
std::optional<std::array<bool, 2>> flat_ends(const Point& form, const DerivativeVector& by,
                                             std::size_t parameter) {
  BivariatePolynomial rate;
  for (std::size_t k = 0; k < 3; ++k) rate += by[k] * BivariatePolynomial::constant(form[k]);
  const Polynomial on_line = parameter == 0 ? rate.at_s(0) : rate.at_r(0);
  if (on_line.is_zero()) return std::nullopt;
  std::array<bool, 2> flat = {};
  for (const RealAlgebraic& root : real_roots(on_line, 0, 1)) {
    if (root.compare(0) != 0 && root.compare(1) != 0) return std::nullopt;
    flat[root.compare(0) == 0 ? 0 : 1] = true;
  }
  return flat;
}

}  // namespace

CoincidentParameters coincidence(const RationalPatch& x, const RationalPatch& y) {
  CoincidentParameters result;
  const std::array<DerivativeVector, 2> of_x = {derivative_by(x, 0), derivative_by(x, 1)};
  const std::array<DerivativeVector, 2> of_y = {derivative_by(y, 0), derivative_by(y, 1)};
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t b = 0; b < 2; ++b) {
      std::vector<Point> constraints;
      append_constraints(constraints, of_x[1 - a]);
      append_constraints(constraints, of_y[1 - b]);
      for (const Point& form : orthogonal_complement(constraints)) {
        const auto on_x = flat_ends(form, of_x[a], a);
        const auto on_y = flat_ends(form, of_y[b], b);
        if (!on_x || !on_y) continue;
        result.partner[a] = 2 + b;
        result.partner[2 + b] = a;
        result.flat[a] = *on_x;
        result.flat[2 + b] = *on_y;
      }
    }
  }
  return result;
}

std::array<std::size_t, 4> coincident_parameters(const RationalPatch& x, const RationalPatch& y) {
  return coincidence(x, y).partner;
}

std::array<std::optional<std::size_t>, 2> plane_coordinates(const BezierPatch& x, const BezierPatch& y) {
  std::array<std::optional<std::size_t>, 2> result;
  for (std::size_t p = 0; p < 2; ++p) {
    const auto plane = plane_of(p == 0 ? x : y);
    for (std::size_t k = 0; plane && k < 3 && !result[p]; ++k) {
      result[p] = plane->normal[k] != 0 ? std::optional(k) : std::nullopt;
    }
  }
  return result;
}

}  // namespace exsect
