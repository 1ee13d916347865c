// Coordinates and weights for the charts of a singular solution, or of one where the curve ends.
#pragma once

#include <exsect/checker/certificate.h>
#include <exsect/solver/intersection_graph.h>

#include <vector>

#include "certificate/algebraic.h"

namespace exsect::cli {

/// Stars at the solution, the most probable first, of size 1 and with rows not yet scaled: the last one is
/// normal to both patches. Along the plane of directions in which both patches move alike the distance of the
/// patches is a quadratic form; where it is c q^2, the weights are those of q^2 + p^(k+1), k = 2, 3, ...
/// Where the tangent planes do not agree it is that of regular.h. Throws NoCertificate if the parameters are
/// in no number field that is found, or a patch is singular.
std::vector<checker::Star> singular_points(const SingularSearch& search, const Node& node);

/// The star at the scale 2^(-e/2), or 3/4 of the next one: its axes multiplied by powers of this, after its
/// weights.
checker::Star at_scale(const checker::Star& star, int e);

}  // namespace exsect::cli
