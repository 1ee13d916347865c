// From traced curves to nodes and arcs with polylines. Internal to solver/.
#pragma once

#include <optional>
#include <vector>

#include "answer/graph_builder.h"
#include "answer/model_scale.h"
#include "trace/turning_points.h"

namespace exsect {

/// A traced curve with all its turning points, in order, and where else its arcs are cut.
template <class Ball, class Tube>
struct AnalysedCurve {
  TubeTrace<Tube> trace;
  TurningPoints<Ball> turning;
  std::vector<TraceCut> cuts = {};
};
template <class Ball>
using AnalysedTrace = AnalysedCurve<Ball, Tube<Ball>>;

/// How an arc goes on from the port of a star to the star's node: vertices in between, and a bound of the
/// distance between the arc and the chords.
struct Approach {
  std::vector<PolylineVertex> vertices;
  double bound;
};

/// Where the traces that end at a landmark lead to.
struct TraceEnd {
  int node;
  std::optional<Approach> approach;  // the landmark is a port
};

/// Node i for landmark i.
std::vector<TraceEnd> nodes_of_landmarks(std::size_t count);

/// Appends the arcs of one trace and its turning nodes with respect to `wanted` parameters (a closed curve
/// without any gets all its turning nodes). `ends` and `landmarks` are indexed as Trace::start. Polylines
/// keep within `tolerance` (space units) of the curve where doubles can express that; Arc::error_bound is
/// what is proved.
template <class Ball>
void append_trace(GraphBuilder& graph, const AnalysedTrace<Ball>& curve, const Landmarks<Ball>& landmarks,
                  const std::vector<TraceEnd>& ends, const ModelFrame& frame,
                  const std::vector<Parameter>& wanted, double tolerance);

}  // namespace exsect
