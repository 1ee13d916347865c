// Turning points of a traced curve with respect to all four parameters. Internal to solver/.
#pragma once

#include <exsect/solver/certified_point.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "trace/tracer.h"

namespace exsect {

/// Exactly one zero of T_i on the curve, i in `parameters`, lies on piece `piece` between the offsets `from`
/// and `to` (in the direction of the trace); `box` encloses that part of the curve.
template <class Ball>
struct TurningPoint {
  std::vector<std::size_t> parameters;
  std::size_t piece;
  double from;
  double to;
  BallPoint<Ball> box;
};
template <class Ball>
using TurningPoints = std::vector<TurningPoint<Ball>>;

/// The curve turns in this parameter at the point.
template <class Ball>
bool turns_in(const TurningPoint<Ball>& point, std::size_t parameter) {
  return std::count(point.parameters.begin(), point.parameters.end(), parameter) > 0;
}

/// The signs of the components of T at a point, 0 where one is known to vanish; empty: unknown.
using TangentSigns = std::array<std::optional<int>, 4>;

/// What is known exactly about a trace: parameters that are constant on it and do not turn, and T at the
/// points where it starts and ends.
struct KnownTangent {
  std::array<bool, 4> constant{};
  TangentSigns at_start{};
  TangentSigns at_end{};
  /// plane_coordinates(x, y). Where a plane y folds, u and v turn together: T_u and T_v contain N_y.
  std::array<std::optional<std::size_t>, 2> plane{};
  /// Asked where two turning points cannot be told apart, unless empty: a box inside `where` that holds a
  /// point of the intersection at which components i and j of T vanish.
  std::function<std::optional<ParameterBox>(const ParameterBox& where, std::size_t i, std::size_t j)>
      common_zero = {};
};

/// All turning points in the order of the trace, apart from its end points. Splits the trace's pieces where
/// that is needed for the proof. `coincident` as above. Fails where a turning point cannot be separated from
/// another one or from an end of the trace.
template <class Ball>
std::variant<TurningPoints<Ball>, TraceFailure> find_turning_points(
    const PairSystem<Ball>& system, Trace<Ball>& trace, const std::array<std::size_t, 4>& coincident,
    const KnownTangent& known = {});

/// False only if the parameter is proved to change along the trace.
template <class Ball>
bool may_be_constant(const Trace<Ball>& trace, std::size_t parameter);

}  // namespace exsect
