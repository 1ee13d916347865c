// The main entry: the exact, complete, certified intersection of two patches.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/options.h>
#include <exsect/solver/result.h>

namespace exsect {

/// Every point of x(u,v) = y(r,s) in [0,1]^4 (method, section 8). Safe to call from several threads. Throws
/// std::invalid_argument for options out of range.
IntersectResult intersect(const BezierPatch& x, const BezierPatch& y, const IntersectOptions& options = {});

}  // namespace exsect
