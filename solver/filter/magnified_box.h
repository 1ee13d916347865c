// What the intersection does in a box of the parameters that is too small for doubles, seen as the
// intersection of the pieces over it. Internal to solver/; docs/method-doubles.md, section 14.23.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include <functional>
#include <optional>
#include <vector>

#include "answer/run.h"
#include "filter/kind.h"

namespace exsect::filter {

/// All solutions in a box: closed curves and isolated points inside of it (14.95), in the parameters of the
/// whole squares. A complete result, without overlaps; nothing where a solution is on a side of the pieces.
struct MagnifiedBox {
  ParameterBox where;
  IntersectResult inside;
  bool meets_side = false;
};

/// Intersects two patches.
using SolvePieces = std::function<IntersectResult(const RationalPatch&, const RationalPatch&, const Run&)>;

/// The complete intersection over a box of the parameters, in the parameters of the whole squares, where no
/// node is on a side, which the box may reach beyond where denominators are positive: `solve` intersects the
/// pieces over the box. Empty if it does not complete that, or `takes` not the pieces' graph. `extent`: of
/// the model.
std::optional<IntersectResult> intersect_over(
    const RationalPatch& x, const RationalPatch& y, const ParameterBox& where, double extent, const Run& run,
    const SolvePieces& solve, const std::function<bool(const IntersectionGraph& of_pieces)>& takes);

/// A box of a width of 2^-12 around a place, centred, of [0,1]^4.
ParameterBox box_to_magnify(const Vec4& place);

/// 32 times as wide, of [0,1]^4: for a curve that is larger than the box.
ParameterBox widened(const ParameterBox& box);

/// Empty if the pieces over the box are not decided, or overlap.
std::optional<MagnifiedBox> magnified(const RationalPatch& x, const RationalPatch& y,
                                      const ParameterBox& where, double extent, const Run& run,
                                      const SolvePieces& solve);

/// The result without what is in the boxes, which are disjoint, and what is in them.
IntersectResult joined(IntersectResult outside, std::vector<MagnifiedBox> boxes, double extent,
                       const Run& run);

}  // namespace exsect::filter
