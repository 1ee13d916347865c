// Intersections of patches of any bidegrees up to (3,3), with or without weights.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/options.h>
#include <exsect/solver/result.h>

#include <stdexcept>
#include <string>

namespace exsect {

/// A patch or surface that a method does not take yet; what() says which: "not supported yet: bidegree
/// (3,3)".
class NotSupported : public std::invalid_argument {
 public:
  explicit NotSupported(const RationalPatch& patch) : NotSupported(kind_of(patch)) {}
  explicit NotSupported(const std::string& what) : std::invalid_argument("not supported yet: " + what) {}
};

/// Every point of x(u,v) = y(r,s) in [0,1]^4, as for biquadratic patches: two patches that are polynomial and
/// of bidegree at most (2,2) take that way. Others, with weights or not, are solved in doubles with proved
/// errors (method, section 14): completely in general position; where doubles do not decide, the result is
/// incomplete and says where and why; Work::steps has the entry "filtered" in both cases. With options.exact
/// they are complete only where an eliminant proves that no curve is missing, near poles aside, as images of
/// polynomial patches, as pieces of one surface, or by an equation. Safe to call from several threads. Throws
/// NotSupported with options.exact where none of this decides and there is neither an eliminant that is
/// affordable nor such an image, and std::invalid_argument for options out of range.
IntersectResult intersect(const RationalPatch& x, const RationalPatch& y,
                          const IntersectOptions& options = {});
/// As self_intersect() of a BezierPatch, which polynomial patches of bidegree at most (2,2) take. Others are
/// solved in doubles (method, section 14.17): completely in general position; where doubles do not decide,
/// the result is incomplete, without a graph. Throws NotSupported with options.exact for these.
IntersectResult self_intersect(const RationalPatch& x, const IntersectOptions& options = {});

}  // namespace exsect
