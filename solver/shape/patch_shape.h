// Whether a patch is a surface, a curve or a point. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>

namespace exsect {

/// The dimension of a patch and how it shows: all control points equal; independent of the second or of the
/// first parameter; x_u and x_v parallel everywhere in another way (x = p(phi(u,v))); or none of these.
enum class PatchShape { point, curve_of_first, curve_of_second, curve, surface };
PatchShape shape(const BezierPatch& x);

}  // namespace exsect
