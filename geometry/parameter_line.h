// Parameter lines of a patch as curves p(t) = a0 + a1 t + a2 t^2, and their shapes.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <array>

namespace exsect {

/// p(t) = a[0] + a[1] t + a[2] t^2 for t in [0,1]: a parabolic arc, or degenerate.
struct ParameterLine {
  std::array<Point, 3> a;

  Point operator()(const Rational& t) const;
};

/// conic: a1 x a2 != 0. straight: a line segment run through monotonically on [0,1]. folded: a line segment
/// whose point turns back at a parameter inside (0,1). point: a1 = a2 = 0. Lines of patches of degree 3 only:
/// plane_cubic, and twisted_cubic, in no plane.
enum class LineShape { conic, straight, folded, point, plane_cubic, twisted_cubic };

/// The line x(u0, .) with parameter v. Any rational u0.
ParameterLine line_at_first(const BezierPatch& x, const Rational& u0);
/// The line x(., v0) with parameter u.
ParameterLine line_at_second(const BezierPatch& x, const Rational& v0);
/// conic, straight, folded or point.
LineShape shape(const ParameterLine& line);

}  // namespace exsect
