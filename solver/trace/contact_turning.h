// Turning points of curves along which the patches touch. Internal to solver/.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "eliminant/exact_pair.h"
#include "trace/tangential_arc.h"
#include "trace/turning_points.h"

namespace exsect {

/// All turning points, in order, those with respect to each parameter apart. Where the derivative of a
/// parameter cannot be told from zero, at most one turning value of it may lie: between two zeros of the
/// derivative there is another one with another value, so that the derivative vanishes there at most once.
/// The parameters marked `constant` do not turn. Fails where a turning point cannot be decided.
template <class Ball>
std::variant<TurningPoints<Ball>, TraceFailure> find_contact_turns(const PairSystem<Ball>& system,
                                                                   const TangentialArc<Ball>& curve,
                                                                   ExactPair& pair,
                                                                   const std::array<bool, 4>& constant);

/// False only if the parameter is proved to change along the curve.
template <class Ball>
bool may_be_constant(const PairSystem<Ball>& system, const TangentialArc<Ball>& curve, std::size_t parameter);

}  // namespace exsect
