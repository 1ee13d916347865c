// The intersection of two patches decided in doubles, where they suffice. Internal to solver/;
// docs/method-doubles.md, section 14.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/rational_patch.h>

#include <optional>

#include "answer/run.h"
#include "eliminant/eliminant_proof.h"

namespace exsect {

/// The complete intersection, with the same proof and the same graph as the exact solution; empty if doubles
/// do not decide it, after a bounded amount of work.
std::optional<IntersectResult> intersect_filtered(const BezierPatch& x, const BezierPatch& y, const Run& run);

/// The same for any two patches; where doubles do not decide, an incomplete result says where the
/// search ended.
IntersectResult intersect_in_doubles(const RationalPatch& x, const RationalPatch& y, const Run& run);

/// The same with what the curves do, for each sweep parameter; empty also where the patches share a corner or
/// a part of a side.
struct FilteredCurves {
  IntersectResult result;
  std::array<std::vector<Stations>, 4> stations;
};
std::optional<FilteredCurves> filtered_curves(const BezierPatch& x, const BezierPatch& y, const Run& run);

}  // namespace exsect
