#include "self/graph.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "answer/graph_builder.h"
#include "trace/arc_polyline.h"
#include "trace/in_domain.h"
#include "trace/tube_points.h"
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
BoundedVertex vertex_at(const ChartSystem<Ball>& system, const BallPoint<Ball>& p, bool exchange,
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

/// A place on a trace in the charts where an arc ends: piece, offset, and the node, -1 at the gate.
struct ChartStop {
  int node;
  std::size_t piece;
  double tau;
  BoundedVertex vertex;
};

/// The arcs of a trace in the charts.
template <class Ball>
class ChartArcs {
 public:
  ChartArcs(GraphBuilder& graph, const SelfSystem<Ball>& system, const ChartTrace<Ball>& trace, bool exchange,
            const ModelFrame& frame, double tolerance)
      : graph_(graph),
        system_(system),
        trace_(trace),
        exchange_(exchange),
        frame_(frame),
        tolerance_(tolerance) {}

  std::vector<Arc> run(const std::vector<Parameter>& wanted, int start_node, int end_node) {
    const ChartPiece<Ball>& first = trace_.pieces.front();
    const ChartPiece<Ball>& last = trace_.pieces.back();
    stops_.push_back({start_node, 0, first.range.from(), vertex(first, first.range.from())});
    for (const TurningPoint<Ball>& point : trace_.turning) {
      add_turning(point, wanted);
    }
    add_cuts();
    stops_.push_back({end_node, trace_.pieces.size() - 1, last.range.to(), vertex(last, last.range.to())});
    std::vector<Arc> arcs;
    for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
      arcs.push_back(arc(stops_[i], stops_[i + 1]));
    }
    return arcs;
  }

 private:
  BoundedVertex vertex(const ChartPiece<Ball>& piece, double tau) const {
    return vertex_at(system_.chart(piece.chart), point_at(piece.tube, tau), piece.exchanged != exchange_,
                     frame_);
  }

  /// Between the stops so far, all but the first of which are turning points.
  void add_cuts() {
    for (const TraceCut& cut : trace_.cuts) {
      const ChartPiece<Ball>& piece = trace_.pieces[cut.piece];
      BallPoint<Ball> at = point_at(piece.tube, cut.tau);
      for (std::size_t j = 0; j < 4; ++j) {
        const double slope = std::fabs(piece.tube.slope[j]) + piece.tube.slope_error[j];
        at[j] = at[j].widened(slope * cut.radius * kSlack);
      }
      stops_.push_back({cut.landmark, cut.piece, cut.tau,
                        vertex_at(system_.chart(piece.chart), at, piece.exchanged != exchange_, frame_)});
    }
    std::stable_sort(stops_.begin() + 1, stops_.end(), [&](const ChartStop& a, const ChartStop& b) {
      return a.piece != b.piece ? a.piece < b.piece : trace_.pieces[a.piece].range.precedes(a.tau, b.tau);
    });
  }

  void add_turning(const TurningPoint<Ball>& point, const std::vector<Parameter>& wanted) {
    Node node{};
    for (const std::size_t j : point.parameters) {
      const auto p = static_cast<Parameter>(exchange_ ? (j + 2) % 4 : j);
      if (std::count(wanted.begin(), wanted.end(), p) > 0) {
        node.wrt.push_back(p);
      }
    }
    if (node.wrt.empty()) {
      return;
    }
    std::sort(node.wrt.begin(), node.wrt.end());
    const ChartPiece<Ball>& piece = trace_.pieces[point.piece];
    const BoundedVertex at =
        vertex_at(system_.chart(piece.chart), point.box, piece.exchanged != exchange_, frame_);
    node.kinds = {NodeKind::turning};
    BallPoint<Ball> pair = pair_on(piece, point.box);
    exchange_if(exchange_, pair);
    for (std::size_t j = 0; j < 4; ++j) {
      node.box[j] = in_domain(pair[j].interval());
    }
    node.approx = at.vertex.parameters;
    node.point = at.vertex.point;
    const int id = graph_.add_node(std::move(node));
    stops_.push_back({id, point.piece, 0.5 * (point.from + point.to), at});
  }

  Arc arc(const ChartStop& from, const ChartStop& to) const {
    Arc result{};
    result.from = from.node;
    result.to = to.node;
    result.place = ArcPlace::interior;
    result.contact = Contact::transversal;
    ArcPolyline line;
    line.add_vertex(from.vertex);
    for (std::size_t p = from.piece; p <= to.piece; ++p) {
      const ChartPiece<Ball>& piece = trace_.pieces[p];
      const double a = p == from.piece ? from.tau : piece.range.from();
      const double b = p == to.piece ? to.tau : piece.range.to();
      const double k = std::ldexp(space_second_derivative(system_.chart(piece.chart), piece.tube),
                                  static_cast<int>(frame_.exponent));
      line.add_chords(k, a, b, tolerance_, [&](double tau) { return vertex(piece, tau); });
      if (p != to.piece) line.add_vertex(vertex(piece, b));
    }
    line.add_vertex(to.vertex);
    result.polyline = line.take_vertices();
    result.error_bound = line.bound();
    return result;
  }

  GraphBuilder& graph_;
  const SelfSystem<Ball>& system_;
  const ChartTrace<Ball>& trace_;
  bool exchange_;
  const ModelFrame& frame_;
  double tolerance_;
  std::vector<ChartStop> stops_;
};

/// The node of a cuspidal point.
template <class Ball>
Node cusp_node(const ChartSystem<Ball>& system, const CuspArc<Ball>& arc, const ModelFrame& frame) {
  const PolylineVertex vertex = vertex_at(system, arc.cusp, false, frame).vertex;
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
  std::vector<Arc> chart_arcs(const ChartTrace<Ball>& trace, bool exchange) {
    const int end = trace.end < 0 ? -1 : first_cusp_ + trace.end;
    return ChartArcs<Ball>(graph_, system_, trace, exchange, frame_, tolerance_)
        .run(wanted_, first_cusp_ + trace.start, end);
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
