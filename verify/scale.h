// Models far from unit size, brought near it by a power of two. Internal to verify/; docs/method-verify.md,
// section 15.
#pragma once

#include <exsect/verify/verdict.h>

#include <array>

#include "compared_side.h"

namespace exsect {

/// The greatest coordinate in magnitude, of nodes and arcs; of a candidate what it states in space.
double largest_coordinate(const IntersectionGraph& graph);
double largest_coordinate(const Candidate& candidate);

/// The power of two 2^e by which the model has to be divided so that squares of distances are doubles: 0
/// as long as the greatest coordinate, of the patches or else of the graph, is between 2^-200 and 2^200, or
/// 0.
int exponent_of_size(const std::array<ComparedSurface, 2>& surfaces, const IntersectionGraph& graph);

/// Divided by 2^e, exactly.
ComparedSurface scaled_down(const ComparedSurface& surface, int e);
/// Divided by 2^e; what underflows in a polyline is added to its bound. Only what a Verifier looks at.
IntersectResult scaled_down(IntersectResult exact, int e);
/// Divided by 2^e, but for what underflows. Throws std::invalid_argument if a coordinate is then beyond
/// max_candidate_number.
Candidate scaled_down(Candidate candidate, int e);

/// All lengths times 2^e, upper bounds rounded up.
Verdict scaled_up(Verdict verdict, int e);

}  // namespace exsect
