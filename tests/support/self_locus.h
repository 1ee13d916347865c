// The curve of self-intersection by two routes that the solver does not take: its resultant form, and exact
// fibres.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/solver/intersection_graph.h>
#include <exsect/solver/line_patch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace exsect::testing {

using VectorPolynomial = std::array<BivariatePolynomial, 3>;

inline BivariatePolynomial bracket(const VectorPolynomial& a, const VectorPolynomial& b,
                                   const VectorPolynomial& c) {
  BivariatePolynomial sum;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3;
    const std::size_t m = (k + 2) % 3;
    sum += a[k] * (b[l] * c[m] - b[m] * c[l]);
  }
  return sum;
}

inline VectorPolynomial negated(VectorPolynomial a) {
  for (BivariatePolynomial& c : a) c *= Polynomial(-1);
  return a;
}

/// Q(u2, v1) of (7.1), u2 in the place of r and v1 in the place of s: zero at all pairs x(u1,v1) = x(u2,v2).
inline BivariatePolynomial self_locus(const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  VectorPolynomial value;
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<Polynomial> rows;
    for (const auto& row : c) rows.emplace_back(std::vector<Rational>{row[0][k], row[1][k], row[2][k]});
    value[k] = BivariatePolynomial(rows);
  }
  VectorPolynomial a;
  VectorPolynomial b;
  VectorPolynomial minus_c;
  VectorPolynomial minus_d;
  for (std::size_t k = 0; k < 3; ++k) {
    b[k] = value[k].derivative_r();
    a[k] = b[k].derivative_r() * Polynomial(Rational(1, 2));
    minus_d[k] = value[k].derivative_s();
    minus_c[k] = minus_d[k].derivative_s() * Polynomial(Rational(1, 2));
  }
  const VectorPolynomial cc = negated(minus_c);
  const VectorPolynomial d = negated(minus_d);
  const VectorPolynomial minus_a = negated(a);
  const BivariatePolynomial d1 = bracket(b, cc, d);
  const BivariatePolynomial d2 = bracket(minus_a, cc, d);
  const BivariatePolynomial d3 = bracket(b, minus_a, d);
  const BivariatePolynomial d4 = bracket(b, cc, minus_a);
  return d1 * d4 * d4 - d2 * d2 * d3;
}

/// How often polylines of the graph cross u1 = value or u2 = value (parameter 0), v1 or v2 = value (parameter
/// 1).
inline int polyline_crossings(const IntersectionGraph& graph, std::size_t parameter, double value) {
  int count = 0;
  for (const Arc& arc : graph.arcs)
    for (const std::size_t j : {parameter, parameter + 2})
      for (std::size_t i = 0; i + 1 < arc.polyline.size(); ++i)
        count +=
            (arc.polyline[i].parameters[j] < value) != (arc.polyline[i + 1].parameters[j] < value) ? 1 : 0;
  return count;
}

/// The exact fibre: the parameter line against the patch itself.
inline std::vector<CertifiedPoint> self_fibre(const BezierPatch& x, std::size_t parameter,
                                              const Rational& value) {
  return line_points(x, x, {parameter == 0 ? Parameter::u : Parameter::v, value}).points;
}

}  // namespace exsect::testing
