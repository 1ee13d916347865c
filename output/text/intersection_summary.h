// The result of `exsect intersect` as text for a reader.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include <string>

#include "output/text/intersection_json.h"

namespace exsect::cli {

/// Status, components, nodes, arcs, time and what is not known, ending with a line feed. Digits of nodes are
/// proved, more of them where `verbose`, which adds what was counted on the way. For a patch and itself x and
/// y are that patch.
std::string intersection_summary(const IntersectResult& result, const PatchNames& names,
                                 const RationalPatch& x, const RationalPatch& y, bool verbose);
/// The same for a patch and a surface given by its equation.
std::string intersection_summary(const IntersectResult& result, const PatchNames& names,
                                 const RationalPatch& x, bool verbose);

}  // namespace exsect::cli
