// Turning points of a traced curve with respect to all four parameters. Internal to solver/; docs/method.md,
// section 14.5.
#pragma once

#include <vector>

#include "filter/trace.h"

namespace exsect::filter {

/// Exactly one point with w_i' = 0, i = parameter, lies on the piece between the offsets `from` and `to`, in
/// the direction of the trace; `ball` holds that part of the curve.
template <class K>
struct TurnOf {
  std::size_t parameter;
  std::size_t piece;
  double from;
  double to;
  BallOf<K> ball;
};
using Turn = TurnOf<Biquadratic>;

enum class TurnSearch {
  done,
  undecided,
  not_separated  // turning points with respect to one parameter of each patch may be the same ones
};

/// All turning points in the order of the trace, apart from its end points, into `turns`; divides pieces
/// where that is needed. Parameters with coincident[i] < i are left out: they turn where coincident[i] does.
template <class K>
TurnSearch find_turns(const PairOf<K>& pair, TraceOf<K>& trace, const std::array<std::size_t, 4>& coincident,
                      std::vector<TurnOf<K>>& turns);

}  // namespace exsect::filter
