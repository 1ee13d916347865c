// From traced curves to the intersection graph with polylines. Internal to solver/; docs/method-doubles.md,
// section 14.6.
#pragma once

#include "answer/graph_builder.h"
#include "filter/double_point.h"
#include "filter/turning.h"

namespace exsect::filter {

/// A traced curve with its turning points in order.
template <class K>
struct AnalysedTraceOf {
  TraceOf<K> trace;
  std::vector<TurnOf<K>> turns;
};
using AnalysedTrace = AnalysedTraceOf<Biquadratic>;

/// How finely polylines are drawn, in space units: within `tolerance` of the curve, their vertices within
/// `vertex_tolerance`, or as near as doubles can be; a bound above `accepted` is refused.
struct Drawing {
  double tolerance;
  double vertex_tolerance;
  double accepted;
};

/// The graph of these curves and centres, which are the whole intersection; turning points with respect
/// to `wanted` parameters are nodes, all of them on a closed curve that has no other. coincident[i] turns
/// where i does. Empty if a polyline cannot be proved to keep within what is accepted.
template <class K>
std::optional<GraphBuilder> make_graph(const PairOf<K>& pair, const std::vector<BoundaryPointOf<K>>& points,
                                       const std::vector<CentreOf<K>>& centres,
                                       const std::vector<AnalysedTraceOf<K>>& traces,
                                       const std::vector<Parameter>& wanted,
                                       const std::array<std::size_t, 4>& coincident, const Drawing& drawing);

}  // namespace exsect::filter
