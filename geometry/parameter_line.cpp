#include "parameter_line.h"

namespace exsect {

Point ParameterLine::operator()(const Rational& t) const { return a[0] + t * (a[1] + t * a[2]); }

ParameterLine line_at_first(const BezierPatch& x, const Rational& u0) {
  const ControlNet c = x.power_basis();
  ParameterLine line;
  for (std::size_t j = 0; j < 3; ++j) line.a[j] = c[0][j] + u0 * (c[1][j] + u0 * c[2][j]);
  return line;
}

ParameterLine line_at_second(const BezierPatch& x, const Rational& v0) {
  return line_at_first(x.exchanged(), v0);
}

LineShape shape(const ParameterLine& line) {
  const Point& a1 = line.a[1];
  const Point& a2 = line.a[2];
  if (is_zero(a1) && is_zero(a2)) return LineShape::point;
  if (!is_zero(cross(a1, a2))) return LineShape::conic;
  if (is_zero(a2)) return LineShape::straight;
  // p'(t) = a1 + 2 t a2 = 2 (t - turn) a2
  const Rational turn = -dot(a1, a2) / (2 * dot(a2, a2));
  return turn > 0 && turn < 1 ? LineShape::folded : LineShape::straight;
}

}  // namespace exsect
