#include "straight_line.h"

#include <stdexcept>

namespace exsect {

StraightLine straight_line(const ParameterLine& line) {
  const LineShape s = shape(line);
  if (s != LineShape::straight && s != LineShape::folded)
    throw std::domain_error("parameter line: neither straight nor folded, it has no direction");
  const auto& [a0, a1, a2] = line.a;
  if (is_zero(a2)) return {a0, a1, Polynomial::variable()};
  const Rational ratio = dot(a1, a2) / dot(a2, a2);  // a1 = ratio a2
  return {a0, a2, Polynomial({Rational(0), ratio, Rational(1)})};
}

StraightForms straight_forms(const ParameterLine& line) {
  const StraightLine l = straight_line(line);
  const Point n1 = cross(l.direction, least_parallel_axis(l.direction));
  const Point n2 = cross(l.direction, n1);
  const Rational scale = 1 / dot(l.direction, l.direction);
  return {form_through(l.a0, n1), form_through(l.a0, n2), form_through(l.a0, scale * l.direction), l.phi};
}

}  // namespace exsect
