// Turning points of a traced curve with respect to all four parameters. Internal to solver/;
// docs/method-doubles.md, section 14.5.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "filter/exact_direction.h"
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

/// What is known of the turning points of a trace beforehand.
template <class K>
struct KnownTurning {
  /// Parameters with coincident[i] < i are left out: they turn where coincident[i] does.
  std::array<std::size_t, 4> coincident = {0, 1, 2, 3};
  /// Left out unless a parameter that turns with them is asked for.
  std::array<bool, 4> unasked = {};
  /// Also left out: constant along the trace.
  std::array<bool, 4> constant = {};
  /// w_i' = 0 at the first and at the last point of the trace, the solutions in these balls.
  std::array<bool, 4> at_start = {};
  std::array<bool, 4> at_end = {};
  std::optional<BallOf<K>> start = {};
  std::optional<BallOf<K>> end = {};
  /// If the trace begins, or ends, in a side point.
  const SidePointOf<K>* start_at = nullptr;
  const SidePointOf<K>* end_at = nullptr;

  /// A line of parameters that is one point of space: no curve, but a node with a free parameter.
  bool is_one_point() const { return std::count(constant.begin(), constant.end(), true) > 2; }
};

/// Somewhere on the trace two parameters certainly change. If not it may be a line that is one point.
template <class K>
bool moves(const TraceOf<K>& trace) {
  return std::any_of(trace.pieces.begin(), trace.pieces.end(), [](const PieceOf<K>& piece) {
    int count = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (std::fabs(piece.tube.slope[i]) > piece.tube.slope_error[i]) ++count;
    return count > 1;
  });
}

/// All turning points in the order of the trace, apart from its end points, into `turns`; divides pieces
/// where that is needed. The first thousand directions are those of the source, if there
/// is one, others of direction_at().
template <class K>
TurnSearch find_turns(const PairOf<K>& pair, TraceOf<K>& trace, const KnownTurning<K>& known,
                      std::vector<TurnOf<K>>& turns, const DirectionSource<K>* source);
template <class K>
TurnSearch find_turns(const PairOf<K>& pair, TraceOf<K>& trace, const KnownTurning<K>& known,
                      std::vector<TurnOf<K>>& turns) {
  return find_turns<K>(pair, trace, known, turns, nullptr);
}

}  // namespace exsect::filter
