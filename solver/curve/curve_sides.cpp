#include "curve/curve_sides.h"

#include <exsect/algebra/triangular_point.h>

#include <algorithm>

namespace exsect {

/// With f = g^m k, m the multiplicity, g = 0 and g_v, k != 0 at the inner point, the m-th derivative of f by
/// v is m! g_v^m k there, and the sign of f above the arc; by u the same for an arc on u = const.
SideSigns signs_beside(const BivariatePolynomial& f, const CurveGraph& curve, const CurveBranch& arc) {
  const bool is_vertical = curve.nodes[arc.from].u == curve.nodes[arc.to].u;
  BivariatePolynomial derivative = f.exchanged();  // v is the first variable of points
  for (int i = 0; i < arc.multiplicity; ++i)
    derivative = is_vertical ? derivative.derivative_s() : derivative.derivative_r();
  const int beyond = sign_at(derivative, arc.inside);  // at greater v, or at greater u
  const int before = arc.multiplicity % 2 == 0 ? beyond : -beyond;
  return is_vertical ? SideSigns{before, beyond} : SideSigns{beyond, before};
}

int sign_around(const BivariatePolynomial& f, const CurveNode& node) {
  const BivariatePolynomial swept = f.exchanged();
  const auto sign_over = [&](const Rational& v) { return sign_at(swept.at_r(v), node.u); };
  if (node.v.lower < node.v.upper) {
    const int above = sign_over(node.v.upper);
    return above != 0 ? above : sign_over(node.v.lower);
  }
  const bool is_high = node.v.lower >= Rational(1, 2);
  for (Rational reach = power_of_two(-4);; reach *= power_of_two(-8)) {
    const Rational beside = is_high ? node.v.lower - reach : node.v.lower + reach;
    const Rational from = std::min(beside, node.v.lower), to = std::max(beside, node.v.lower);
    if (roots_at(swept, node.u, from, to).size() == 1) return sign_over(beside);
  }
}

}  // namespace exsect
