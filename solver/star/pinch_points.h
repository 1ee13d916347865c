// Points of the intersection at which one of the patches is singular. Internal to solver/; docs/method.md,
// section 6.4.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/certified_point.h>

#include <vector>

namespace exsect {

/// The solutions of x(u,v) = y(r,s) in [0,1]^4 at the points x_u × x_v = 0 of x and y_r × y_s = 0 of y that
/// are isolated among such points and whose two parameters on that patch are rational: (6.3a). Multiplicity
/// and branch are 0.
std::vector<CertifiedPoint> pinch_points(const BezierPatch& x, const BezierPatch& y);

}  // namespace exsect
