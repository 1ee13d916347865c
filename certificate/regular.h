// Stars at regular solutions: the curve runs through the point, but not on inside the domain, or turns at a
// side.
#pragma once

#include <exsect/checker/certificate.h>
#include <exsect/solver/intersection_graph.h>

#include <optional>

#include "certificate/algebraic.h"
#include "certificate/near_pair.h"

namespace exsect::cli {

/// A star of size 1, with rows not yet scaled, in which a parameter that differs from the point's by
/// c t^n + ... along the curve has weight n <= 6, and both half branches begin inside one chart each. Nothing
/// if DF has no rank 3.
std::optional<checker::Star> regular_star(const ExactMap& equation, const AlgebraicPoint& at);

/// The parameters that stay along the curve where they are at the point, to six orders at least; none if DF
/// has no rank 3.
std::array<bool, 4> constant_at(const ExactMap& equation, const AlgebraicPoint& at);

/// The parameter of a side on which the node is turns there: exactly, as its derivative along the curve is 0,
/// where it is near 0 and the second one is not. `near`: F in doubles.
bool turns_at_side(const Map& near, const SingularSearch& search, const Node& node);

}  // namespace exsect::cli
