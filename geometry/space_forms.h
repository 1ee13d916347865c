// The forms of space that equations of surfaces are made of. Internal to geometry/.
#pragma once

#include <exsect/geometry/space_polynomial.h>

namespace exsect {

/// normal . p + constant
SpacePolynomial affine_form(const Point& normal, const Rational& constant);
/// (p - c) . d
SpacePolynomial height_form(const Point& c, const Point& d);
/// |p - c|^2
SpacePolynomial squared_distance(const Point& c);

}  // namespace exsect
