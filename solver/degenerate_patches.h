// Patches that are a curve or a single point, against any patch. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <optional>

#include "run.h"

namespace exsect {

/// The dimension of a patch and how it shows: all control points equal; independent of the second or of the
/// first parameter; x_u and x_v parallel everywhere in another way (x = p(phi(u,v))); or none of these.
enum class PatchShape { point, curve_of_first, curve_of_second, curve, surface };
PatchShape shape(const BezierPatch& x);

/// The intersection if one of the patches is a curve or a point; empty if both are surfaces.
std::optional<IntersectResult> intersect_degenerate(const BezierPatch& x, const BezierPatch& y,
                                                    const Run& run);

}  // namespace exsect
