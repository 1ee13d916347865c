#include "self/graph.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "answer/graph_builder.h"
#include "trace/curve_appender.h"

namespace exsect {

namespace {

template <class T>
void exchange_if(bool exchange, std::array<T, 4>& p) {
  if (exchange) {
    p = exchanged_pair(p);
  }
}

/// The point p of a chart, in the order of t > 0 or exchanged.
template <class Ball>
BoundedVertex chart_vertex(const ChartSystem<Ball>& system, const BallPoint<Ball>& p, bool exchange,
                           const ModelFrame& frame) {
  BoundedVertex result = bounded_position(space_point(system, p), frame);
  const double t = std::sqrt(std::max(0.0, p[3].approximation()));
  const double mt = p[2].approximation() * t;
  const double a = p[0].approximation();
  const double b = p[1].approximation();
  result.vertex.parameters = system.chart() == Chart::first
                                 ? std::array<double, 4>{a + t, b + mt, a - t, b - mt}
                                 : std::array<double, 4>{b + mt, a + t, b - mt, a - t};
  exchange_if(exchange, result.vertex.parameters);
  return result;
}

/// Draws a trace in the charts (curve_appender.h).
template <class Ball>
struct ChartPen {
  using Number = Ball;
  static constexpr Contact contact = Contact::transversal;

  const SelfSystem<Ball>& system;
  const ChartTrace<Ball>& curve;
  bool exchanged;
  const ModelFrame& frame;
  double tolerance;

  const auto& pieces() const { return curve.pieces; }
  BallPoint<Ball> pair(std::size_t piece, const BallPoint<Ball>& box) const {
    BallPoint<Ball> result = pair_on(pieces()[piece], box);
    exchange_if(exchanged, result);
    return result;
  }
  BoundedVertex vertex(std::size_t piece, const BallPoint<Ball>& box) const {
    return chart_vertex(chart(piece), box, pieces()[piece].exchanged != exchanged, frame);
  }
  BoundedVertex vertex_at(std::size_t piece, double tau) const {
    return vertex(piece, point_at(pieces()[piece].tube, tau));
  }
  void add_chords(ArcPolyline& line, std::size_t piece, double a, double b) const {
    const double k = std::ldexp(space_second_derivative(chart(piece), pieces()[piece].tube),
                                static_cast<int>(frame.exponent));
    line.add_chords(k, a, b, tolerance, [&](double tau) { return vertex_at(piece, tau); });
  }

  const ChartSystem<Ball>& chart(std::size_t piece) const { return system.chart(pieces()[piece].chart); }

  CurveStop stop(int node, std::size_t piece, double tau) const {
    return {node, {piece, tau}, vertex_at(piece, tau)};
  }
  CurveStop stop_at(const TraceCut& cut) const {
    const ChartTube<Ball>& tube = pieces()[cut.piece].tube;
    BallPoint<Ball> at = point_at(tube, cut.tau);
    for (std::size_t j = 0; j < 4; ++j) {
      at[j] = at[j].widened((std::fabs(tube.slope[j]) + tube.slope_error[j]) * cut.radius * kSlack);
    }
    return {cut.landmark, {cut.piece, cut.tau}, vertex(cut.piece, at)};
  }
};

/// The node of a cuspidal point.
template <class Ball>
Node cusp_node(const ChartSystem<Ball>& system, const CuspArc<Ball>& arc, const ModelFrame& frame) {
  const PolylineVertex vertex = chart_vertex(system, arc.cusp, false, frame).vertex;
  const std::size_t first = arc.chart == Chart::first ? 0 : 1;
  const RationalInterval u = arc.cusp[first].interval();
  const RationalInterval v = arc.cusp[1 - first].interval();
  Node node{};
  node.kinds = {NodeKind::cusp};
  node.box = {u, v, u, v};
  node.approx = vertex.parameters;
  node.point = vertex.point;
  for (std::size_t j = 0; j < 4; ++j) {
    const auto& side = arc.place.side[(j + first) % 2];
    if (side) {
      node.on.push_back({static_cast<Parameter>(j), *side});
      node.box[j] = {*side, *side};
      node.approx[j] = *side;
    }
  }
  if (!node.on.empty()) {
    node.kinds.push_back(NodeKind::boundary);
  }
  return node;
}

/// The arcs run through in the other direction.
void reverse(std::vector<Arc>& arcs) {
  std::reverse(arcs.begin(), arcs.end());
  for (Arc& arc : arcs) {
    std::reverse(arc.polyline.begin(), arc.polyline.end());
    std::swap(arc.from, arc.to);
  }
}

/// Joins two lists of arcs; the last arc of `first` and the first of `second` meet at a gate and become one.
std::vector<Arc> joined(std::vector<Arc> first, std::vector<Arc> second) {
  Arc& before = first.back();
  const Arc& after = second.front();
  before.polyline.insert(before.polyline.end(), after.polyline.begin() + 1, after.polyline.end());
  before.to = after.to;
  before.error_bound = larger_bound(before.error_bound, after.error_bound);
  first.insert(first.end(), std::make_move_iterator(second.begin() + 1),
               std::make_move_iterator(second.end()));
  return first;
}

template <class Ball>
class SelfGraph {
 public:
  SelfGraph(GraphBuilder& graph, const SelfSystem<Ball>& system, const SelfCurves<Ball>& found,
            const std::vector<TraceEnd>& ends, const ModelFrame& frame, const std::vector<Parameter>& wanted,
            double tolerance)
      : graph_(graph),
        system_(system),
        found_(found),
        ends_(ends),
        frame_(frame),
        wanted_(wanted),
        tolerance_(tolerance) {
    first_cusp_ = static_cast<int>(graph.nodes().size());
    for (const CuspArc<Ball>& cusp : found.cusps) {
      graph.add_node(cusp_node(system.chart(cusp.chart), cusp, frame));
    }
  }

  void run() {
    for (const ChartTrace<Ball>& trace : found_.chart_traces) {
      if (trace.end >= 0) {
        append(chart_arcs(trace, false), {});
      }
    }
    for (const SelfCurve<Ball>& curve : found_.curves) {
      const auto before = static_cast<int>(graph_.arcs().size());
      append_trace(graph_, curve.analysed, found_.landmarks, ends_, frame_, wanted_, tolerance_);
      std::vector<Arc> arcs = graph_.take_arcs(before);
      if (const auto lead = arcs_to_gate(curve.analysed.trace.start)) {
        arcs = joined(*lead, std::move(arcs));
      }
      if (auto tail = arcs_to_gate(curve.analysed.trace.end)) {
        reverse(*tail);
        arcs = joined(std::move(arcs), std::move(*tail));
      }
      append(std::move(arcs), curve.on);
    }
  }

 private:
  /// From the cuspidal point to the other one, or to the gate, which is no node: -1.
  std::vector<Arc> chart_arcs(const ChartTrace<Ball>& trace, bool exchange) {
    const ChartPen<Ball> pen{system_, trace, exchange, frame_, tolerance_};
    const auto before = static_cast<int>(graph_.arcs().size());
    CurveAppender appender(graph_, pen);
    appender.add_turning_nodes(wanted_);
    appender.add_cuts([&](const TraceCut& cut) { return pen.stop_at(cut); });
    appender.add_open(pen.stop(first_cusp_ + trace.start, 0, trace.pieces.front().range.from()),
                      pen.stop(trace.end < 0 ? -1 : first_cusp_ + trace.end, trace.pieces.size() - 1,
                               trace.pieces.back().range.to()));
    return graph_.take_arcs(before);
  }

  /// From the cuspidal point to the gate, if the landmark is one.
  std::optional<std::vector<Arc>> arcs_to_gate(int landmark) {
    const auto gate = found_.gate(landmark);
    if (!gate) {
      return std::nullopt;
    }
    return chart_arcs(found_.chart_traces[gate->trace], gate->exchanged);
  }

  void append(std::vector<Arc> arcs, const std::vector<Side>& on) {
    for (Arc& arc : arcs) {
      for (const Side& side : on) {
        put_on_side(arc, side);
      }
      graph_.add_arc(std::move(arc));
    }
  }

  /// The arc lies on the side.
  static void put_on_side(Arc& arc, const Side& side) {
    arc.place = ArcPlace::patch_boundary;
    for (PolylineVertex& vertex : arc.polyline) {
      vertex.parameters[index(side.parameter)] = side.value;
    }
  }

  GraphBuilder& graph_;
  const SelfSystem<Ball>& system_;
  const SelfCurves<Ball>& found_;
  const std::vector<TraceEnd>& ends_;
  const ModelFrame& frame_;
  const std::vector<Parameter>& wanted_;
  double tolerance_;
  int first_cusp_;
};

}  // namespace

template <class Ball>
void append_self_curves(GraphBuilder& graph, const SelfSystem<Ball>& system, const SelfCurves<Ball>& found,
                        const std::vector<TraceEnd>& ends, const ModelFrame& frame,
                        const std::vector<Parameter>& wanted, double tolerance) {
  SelfGraph<Ball>(graph, system, found, ends, frame, wanted, tolerance).run();
}

#define EXSECT_INSTANTIATE_SELF_GRAPH(Ball)                                                         \
  template void append_self_curves(GraphBuilder&, const SelfSystem<Ball>&, const SelfCurves<Ball>&, \
                                   const std::vector<TraceEnd>&, const ModelFrame&,                 \
                                   const std::vector<Parameter>&, double);

EXSECT_INSTANTIATE_SELF_GRAPH(DoubleBall)
EXSECT_INSTANTIATE_SELF_GRAPH(ArbBall<256>)
#undef EXSECT_INSTANTIATE_SELF_GRAPH

}  // namespace exsect
