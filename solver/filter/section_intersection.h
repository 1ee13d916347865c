// A patch and a surface given by its equation whose curve doubles decide. Internal to solver/;
// docs/method-equations.md, section 17.22.
#pragma once

#include <exsect/geometry/implicit_surface.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include <optional>

#include "answer/run.h"

namespace exsect {

/// The same graph as surface_graph() makes, with its proof; empty if doubles do not decide it, or do not draw
/// it to the tolerance of the run, and for a surface with a box. Nodes are ascending in u.
std::optional<IntersectResult> section_intersection(const ImplicitSurface& surface, const RationalPatch& x,
                                                    const Run& run);

}  // namespace exsect
