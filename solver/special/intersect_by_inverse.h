// Pairs of which one patch has an inverse of forms: an equation on the other one, cut by its sides. Internal
// to solver/; docs/method-equations.md, section 17.19.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include <memory>
#include <optional>

#include "answer/run.h"
#include "special/inverse_graph.h"
#include "special/patch_inverse.h"

namespace exsect {

/// What x and y have in common, in the square of x, by the inverse of y; turning points are those that the
/// run asks for. Null if a part of the curve inside of x is one point of x, the curve, or a side of y where x
/// lies on its surface, is of too high degrees in x, or a pole of y is on them and not known exactly, or is
/// one of x as well.
std::shared_ptr<const InverseCurve> curve_by_inverse(const RationalPatch& x, const RationalPatch& y,
                                                     const PatchInverse& of_y, const Run& run);

/// The graph of the curve, which is not null. An arc that ends in a pole of y, one of `in_poles`, has there,
/// for the parameter along its side, only about that of the vertex next to it.
std::optional<IntersectResult> intersect_by_inverse(std::shared_ptr<const InverseCurve> curve,
                                                    const Run& run);

}  // namespace exsect
