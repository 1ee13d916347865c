#include "line_forms.h"

#include <array>
#include <vector>

namespace exsect {
namespace {

/// Three polynomials in s: the coefficient of one power of r in y - a0.
using PolynomialVector = std::array<Polynomial, 3>;

PolynomialVector cross(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Polynomial dot(const IntegerVector& n, const PolynomialVector& a) {
  Polynomial sum;
  for (std::size_t k = 0; k < 3; ++k)
    if (!n[k].is_zero()) sum += Polynomial(Rational(n[k])) * a[k];
  return sum;
}

IntegerVector cross(const IntegerVector& a, const IntegerVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// w[i]: the coefficient of r^i in weight y - a0.
std::array<PolynomialVector, 3> coefficients_of_r(const IntegerLineAndPatch& problem) {
  std::array<PolynomialVector, 3> w;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<Rational> in_s;
      for (std::size_t j = 0; j < 3; ++j) in_s.emplace_back(problem.line.weight * problem.patch[i][j][k]);
      if (i == 0) in_s[0] -= problem.line.a[0][k];
      w[i][k] = Polynomial(in_s);
    }
  return w;
}

}  // namespace

ConicForms conic_forms(const IntegerLineAndPatch& problem) {
  const IntegerVector& a1 = problem.line.a[1];
  const IntegerVector& a2 = problem.line.a[2];
  const std::array<PolynomialVector, 3> w = coefficients_of_r(problem);
  const IntegerVector n = cross(a1, a2);
  const Polynomial a = dot(n, w[2]);
  const Polynomial b = dot(n, w[1]);
  const Polynomial c = dot(n, w[0]);
  const PolynomialVector w02 = cross(w[0], w[2]);
  const PolynomialVector w12 = cross(w[1], w[2]);
  const PolynomialVector w01 = cross(w[0], w[1]);
  const Polynomial la = dot(a2, w02);
  const Polynomial lb = dot(a2, w12);
  const Polynomial lc = dot(a2, w01);
  const Polynomial ma = dot(a1, w02);
  const Polynomial mb = dot(a1, w12);
  const Polynomial mc = dot(a1, w01);

  const Polynomial two(2);
  const Polynomial aa = a * a;
  const Polynomial lala = la * la;
  const Polynomial lalb = la * lb;
  const Polynomial lama = la * ma;
  const Polynomial rl = lala - lb * lc;
  const Polynomial rm = ma * ma - mb * mc;
  const Polynomial pml = two * lama - lb * mc - mb * lc;
  const Polynomial pul = two * la * a - lb * b;
  const Polynomial pmu = two * ma * a - mb * b;
  ConicForms result{a, b, c, {}, {}, {}, {}};
  result.eliminant = aa * rm - pml * pul + rl * pmu + rl * rl;
  result.s1 = a * (a * mb - two * lalb) + b * (lb * lb);
  result.s0 = a * (a * ma - lala) + c * (lb * lb);
  result.t_numerator = a * (la * mb - lb * ma) - lb * rl;
  return result;
}

}  // namespace exsect
