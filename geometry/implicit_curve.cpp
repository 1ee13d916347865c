#include "implicit_curve.h"

#include <exsect/algebra/determinant.h>

#include <stdexcept>

#include "homogeneous_composition.h"

namespace exsect {
namespace {

/// f without repeated factors.
BivariatePolynomial without_repetition(const BivariatePolynomial& f) {
  const BivariatePolynomial derivative = f.degree_r() > 0 ? f.derivative_r() : f.derivative_s();
  return exact_quotient(f, gcd(f, derivative));
}

}  // namespace

std::vector<std::vector<BivariatePolynomial>> bezout_matrix(const HomogeneousCurve& curve) {
  const int n = curve.degree();
  // P = X - x W, Q = Y - y W by powers of t.
  std::vector<BivariatePolynomial> p, q;
  for (int k = 0; k <= n; ++k) {
    const BivariatePolynomial w = BivariatePolynomial::constant(curve.denominator.coefficient(k));
    p.push_back(BivariatePolynomial::constant(curve.numerators[0].coefficient(k)) -
                BivariatePolynomial::r() * w);
    q.push_back(BivariatePolynomial::constant(curve.numerators[1].coefficient(k)) -
                BivariatePolynomial::s() * w);
  }
  const auto bracket = [&](int a, int b) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    return p[i] * q[j] - p[j] * q[i];
  };
  std::vector<std::vector<BivariatePolynomial>> matrix;
  for (int i = 0; i < n; ++i) {
    matrix.emplace_back();
    for (int j = 0; j < n; ++j) {
      BivariatePolynomial sum;
      for (int k = 0; k <= std::min(i, n - 1 - j); ++k) sum += bracket(j + k + 1, i - k);
      matrix.back().push_back(std::move(sum));
    }
  }
  return matrix;
}

ImplicitCurve implicit_curve(const BezierCurve& curve) {
  if (curve.dimension() != 2) throw std::invalid_argument("implicit curve: the curve must be planar");
  if (curve.is_point()) throw std::invalid_argument("implicit curve: all points are equal");
  const HomogeneousCurve reduced = homogeneous(curve);
  const BivariatePolynomial power = determinant(bezout_matrix(reduced));
  BivariatePolynomial equation = primitive(without_repetition(power));
  if (equation.coefficient(equation.degree_r()).leading_coefficient() < 0) equation *= Polynomial(-1);
  return {equation, power.total_degree() / equation.total_degree()};
}

Polynomial composed(const BivariatePolynomial& f, const HomogeneousCurve& curve) {
  return homogeneous_composition(f, curve.numerators[0], curve.numerators[1], curve.denominator,
                                 f.total_degree());
}

}  // namespace exsect
