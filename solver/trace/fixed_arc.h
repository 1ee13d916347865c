// Arcs of the intersection that a symmetry of space fixes. Internal to solver/; docs/method.md, section 5.
#pragma once

#include <algorithm>

#include "shape/exchanging_symmetry.h"
#include "trace/tracer.h"

namespace exsect {

/// True only if all points of the tube's arc are fixed: one is, and the direction there. On the arc, and on
/// its continuation, parameters turn together with their partners.
template <class Ball>
bool is_fixed(const ExchangingSymmetry& symmetry, const Tube<Ball>& tube);

/// As above, of some tube.
template <class Ball>
bool is_fixed(const ExchangingSymmetry& symmetry, const Trace<Ball>& trace) {
  return std::any_of(trace.pieces.begin(), trace.pieces.end(),
                     [&](const Piece<Ball>& piece) { return is_fixed(symmetry, piece.tube); });
}

}  // namespace exsect
