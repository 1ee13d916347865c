// Equations on the patch (p, q, 0), -1 <= p, q <= 1, where they are plane curves as they stand.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include "filter/section_forms.h"

namespace exsect::square_section {

inline RationalPatch square() {
  return RationalPatch(std::vector<std::vector<Point>>{{{-1, -1, 0}, {-1, 1, 0}}, {{1, -1, 0}, {1, 1, 0}}});
}
inline SquareForm form_of(const SpacePolynomial& f) { return section_forms(f, square()).value().section; }
inline SquareForm form_of(const ImplicitSurface& surface) { return form_of(surface.equation()); }
/// The circle about (x,y).
inline SquareForm circle(const Rational& x, const Rational& y, const Rational& radius) {
  return form_of(ImplicitSurface::sphere({x, y, 0}, radius));
}

}  // namespace exsect::square_section
