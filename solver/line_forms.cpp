#include "line_forms.h"

namespace exsect {
namespace {

using Vectors = std::array<Point, 3>;

/// The smallest positive integer by which coordinate k of all given numbers must be multiplied to become
/// integers.
Integer common_denominator(const ParameterLine& line, const ControlNet& c, std::size_t k) {
  Integer result = 1;
  for (const Point& a : line.a) result = lcm(result, Integer(denominator(a[k])));
  for (const auto& row : c)
    for (const Point& p : row) result = lcm(result, Integer(denominator(p[k])));
  return result;
}

/// Scales each coordinate to integers: a linear map of space, which multiplies every form by a positive
/// constant.
void clear_denominators(ParameterLine& line, ControlNet& c) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational scale(common_denominator(line, c, k));
    if (scale == 1) continue;
    for (Point& a : line.a) a[k] *= scale;
    for (auto& row : c)
      for (Point& p : row) p[k] *= scale;
  }
}

PolynomialVector cross(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Polynomial dot(const Point& n, const PolynomialVector& a) {
  return Polynomial(n[0]) * a[0] + Polynomial(n[1]) * a[1] + Polynomial(n[2]) * a[2];
}

}  // namespace

ConicForms conic_forms(const LineAndPatch& problem) {
  ParameterLine line = problem.line;
  ControlNet net = problem.patch.power_basis();
  clear_denominators(line, net);
  const auto& [a0, a1, a2] = line.a;
  net[0][0] = net[0][0] - a0;
  std::array<PolynomialVector, 3> w;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      w[i][k] = Polynomial(std::vector<Rational>{net[i][0][k], net[i][1][k], net[i][2][k]});

  const Point n = exsect::cross(a1, a2);
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
