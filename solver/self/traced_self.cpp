#include "self/traced_self.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "answer/arc_joints.h"
#include "answer/coarse_drawing.h"
#include "answer/finished_result.h"
#include "answer/proof.h"
#include "self/degenerate.h"
#include "self/folds.h"
#include "self/graph.h"
#include "self/pair_orders.h"
#include "self/star_graph.h"
#include "trace/landmark_node.h"
#include "trace/regular_degree.h"

namespace exsect {

template <class Ball>
GraphBuilder drawn_curves(const TracedSelf<Ball>& self, const Run& run) {
  const SelfCurves<Ball>& found = self.curves;
  const ModelFrame& frame = self.scale.frame;
  const std::vector<CertifiedPoint>& points = self.exact.boundary.points;
  GraphBuilder graph;
  for (std::size_t i = 0; i < found.landmarks.size(); ++i) {
    ParameterBox box;
    for (std::size_t j = 0; j < 4; ++j) {
      box[j] = i < points.size() ? points[i].box()[j] : found.landmarks[i][j].interval();
    }
    const std::vector<Side> sides = i < points.size() ? points[i].sides() : std::vector<Side>{};
    graph.add_node(landmark_node(self.system.pair, frame, found.landmarks[i], box, sides));
  }
  for (const int id : found.isolated) graph.add_isolated(id);
  const double tolerance = run.drawn_tolerance(self.scale.extent);
  const std::vector<TraceEnd> ends = ends_at_stars(graph, self.x, self.system, self.exact, found, frame);
  append_folds(graph, self.x, self.system, self.exact, found, ends, frame, tolerance);
  append_self_curves(graph, self.system, found, ends, frame, in_both_orders(run.turning()), tolerance);
  for (const SelfCurve<Ball>& curve : found.curves) {
    run.count("tubes", static_cast<double>(curve.analysed.trace.pieces.size()));
  }
  for (const ChartTrace<Ball>& trace : found.chart_traces) {
    run.count("tubes", static_cast<double>(trace.pieces.size()));
  }
  for (const Arc& arc : graph.arcs()) {
    run.count("vertices", static_cast<double>(arc.polyline.size()));
  }
  return graph;
}

template GraphBuilder drawn_curves(const TracedSelf<DoubleBall>&, const Run&);
template GraphBuilder drawn_curves(const TracedSelf<ArbBall<256>>&, const Run&);

GraphBuilder drawn_pairs(const KnownSelf& known, const Run& run) {
  GraphBuilder graph = known.curves ? known.curves(run) : GraphBuilder();
  for (const auto& [fixed, value] : known.collapsed_sides)
    graph.add_isolated(graph.add_node(collapsed_line_node(known.x, static_cast<std::size_t>(fixed), value)));
  return graph;
}

IntersectResult drawn(const KnownSelf& known, const Run& run) {
  GraphBuilder graph = drawn_pairs(known, run);
  join_orders(graph, known.mates);
  const std::vector<Parameter>& wanted = run.turning();
  const auto is_wanted = [&](Parameter p) { return std::ranges::count(wanted, p) > 0; };
  if (!std::ranges::all_of(in_both_orders(wanted), is_wanted))
    join_at_other_turning_points(graph, 0, 0, wanted);
  return finished(std::move(graph), {wanted, RegularDegree(known.x, known.x), true}, known.incomplete);
}

IntersectResult kept(KnownSelf known, const Run& run) {
  const double tolerance = run.tolerance(1);
  const double extent = model_scale(known.x, known.x).extent;
  const auto all = std::make_shared<const KnownSelf>(std::move(known));
  const Draw draw = [all, tolerance, extent](const Run& given) -> std::optional<IntersectResult> {
    IntersectResult result = drawn(*all, given);
    const bool smaller_may_help = all->has_stars && given.tolerance(1) < tolerance;
    if (smaller_may_help && coarse_drawing(result.graph, given.drawn_tolerance(extent))) return std::nullopt;
    return result;
  };
  return *first_drawn(draw, run);
}

}  // namespace exsect
