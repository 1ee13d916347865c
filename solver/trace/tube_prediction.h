// Where the curve is about to go. Internal to solver/.
#pragma once

#include <optional>

#include "trace/tube.h"

namespace exsect {

/// About the curve's point at the offset tau in coordinate `axis` from the curve point `from` (an estimate,
/// not a proof), by the Taylor polynomial of a tube's centre line. Beside a second branch at the distance e,
/// where Newton's method converges fast only from within e of the curve, a straight line would miss.
template <class Ball>
std::optional<BallPoint<Ball>> predicted(const PairSystem<Ball>& system, const BallPoint<Ball>& from,
                                         std::size_t axis, double tau);

}  // namespace exsect
