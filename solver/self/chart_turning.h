// Turning points of a trace in a chart. Internal to solver/.
#pragma once

#include "self/chart_trace.h"

namespace exsect {

/// Finds all turning points of the trace; splits its pieces where that is needed for the proof. `coincident`
/// as in find_turning_points(). Fails where a turning point cannot be separated from another one or from the
/// gate, and where it must stop.
template <class Ball>
std::optional<TraceFailure> find_chart_turning_points(const Charts<Ball>& charts, ChartTrace<Ball>& trace,
                                                      const std::array<std::size_t, 4>& coincident,
                                                      const StopRequest& stop);

}  // namespace exsect
