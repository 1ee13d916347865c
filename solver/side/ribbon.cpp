#include "side/ribbon.h"

#include <cmath>
#include <cstddef>

namespace exsect {

namespace {

Point rounded(const std::array<double, 3>& v, double length) {
  Point result;
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = from_double(std::ldexp(std::round(std::ldexp(v[c], 16)), -16)) * from_double(length);
  return result;
}

}  // namespace

BezierPatch ribbon(const ParameterLine& line, const RibbonNormal& n) {
  ControlNet c;
  for (std::size_t i = 0; i < 3; ++i) c[i] = {line.a[i] - Rational(1, 2) * n[i], n[i], Point{0, 0, 0}};
  return BezierPatch::from_power_basis(c);
}

Point with_length(const Point& v, double length) {
  std::array<double, 3> d = {to_double(v[0]), to_double(v[1]), to_double(v[2])};
  const double norm = std::hypot(d[0], d[1], d[2]);
  if (!(norm > 0)) return {0, 0, 0};
  for (double& c : d) c /= norm;
  return rounded(d, length);
}

RibbonNormal interpolated(const std::array<Point, 3>& at, const Rational& from, const Rational& to) {
  const auto& [a, m, b] = at;  // at tau = 0, 1/2, 1, t = from + tau (to - from)
  const Point linear = Rational(4) * m - Rational(3) * a - b;
  const Point quadratic = Rational(2) * (a + b) - Rational(4) * m;
  const Rational scale = 1 / (to - from);
  const Rational shift = -from * scale;  // tau = shift + scale t
  return {a + shift * (linear + shift * quadratic), scale * (linear + (2 * shift) * quadratic),
          scale * scale * quadratic};
}

}  // namespace exsect
