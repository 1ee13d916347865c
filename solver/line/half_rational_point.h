// Intersection points whose two parameters on one of the patches are rational numbers. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/certified_point.h>

#include <array>
#include <vector>

namespace exsect {

struct HalfRationalPoint {
  CertifiedPoint point;  // multiplicity and branch 0
  /// Which components of the tangent field vanish, exactly; singular: all do.
  std::array<bool, 4> tangent_is_zero;
  bool singular() const {
    return tangent_is_zero[0] && tangent_is_zero[1] && tangent_is_zero[2] && tangent_is_zero[3];
  }
};

/// The isolated solutions of x(u,v) = y(r,s) in [0,1]^4 at given values in [0,1] of u and v (`of_x`), or of r
/// and s: exact zeros of three polynomials in the parameters of the other patch.
std::vector<HalfRationalPoint> half_rational_points(const BezierPatch& x, const BezierPatch& y, bool of_x,
                                                    const std::array<Rational, 2>& at);

}  // namespace exsect
