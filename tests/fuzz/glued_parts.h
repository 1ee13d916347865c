// An intersection by subdivision: both patches are cut, the parts solved, and their curves glued.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/intersection_graph.h>

#include <optional>
#include <string>

namespace exsect::glued_parts {

/// Where x is cut in its first parameter and y in its second one.
struct Cuts {
  Rational u;
  Rational s;
};

/// Empty if the four pairs of parts, glued along the cuts, have the curves of the whole: the same ends, in
/// the same pairs, and as many closed curves, branched ones and isolated points. Otherwise the first
/// difference in words. Nothing if a part is not complete, or an arc has a free parameter. Requires a
/// complete graph of x and y without overlaps.
std::optional<std::string> difference(const RationalPatch& x, const RationalPatch& y,
                                      const IntersectionGraph& whole, const Cuts& cuts);

}  // namespace exsect::glued_parts
