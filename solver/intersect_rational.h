// Intersections of patches of any bidegree up to (3,3), with or without weights.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/options.h>
#include <exsect/solver/result.h>

#include <stdexcept>

namespace exsect {

/// A patch that a method does not take yet; what() names its kind: "not supported yet: bidegree (3,3)".
class NotSupported : public std::invalid_argument {
 public:
  explicit NotSupported(const RationalPatch& patch)
      : std::invalid_argument("not supported yet: " + kind_of(patch)) {}
};

/// As intersect() of two BezierPatch, for two patches that are polynomial of bidegree at most (2,2), in
/// whatever shape they are given. Throws NotSupported for others.
IntersectResult intersect(const RationalPatch& x, const RationalPatch& y,
                          const IntersectOptions& options = {});
/// The same for self_intersect().
IntersectResult self_intersect(const RationalPatch& x, const IntersectOptions& options = {});

}  // namespace exsect
