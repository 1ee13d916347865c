#include "overlap/two_piece_graph.h"

#include "answer/graph_builder.h"
#include "overlap/pair_map.h"
#include "self/graph.h"
#include "trace/landmark_node.h"

namespace exsect {

namespace {

template <class Ball>
class TwoPieceGraph {
 public:
  TwoPieceGraph(GraphBuilder& graph, const TwoPieces& pieces, const SelfSystem<Ball>& shared,
                const PairSystem<Ball>& system, const TwoPieceCurves<Ball>& found, const ModelFrame& frame,
                const std::vector<Parameter>& wanted, double tolerance)
      : graph_(graph),
        shared_(shared),
        system_(system),
        found_(found),
        frame_(frame),
        wanted_(wanted),
        tolerance_(tolerance),
        boundary_points_(found.boundary_points),
        from_common_(pieces.copy, pieces.common) {}

  void run() {
    for (const int id : found_.isolated) {
      graph_.add_isolated(id);
    }
    for (std::size_t i = boundary_points_; i < found_.landmarks.size(); ++i) {
      add_gate(found_.landmarks[i]);
    }
    first_cusp_ = static_cast<int>(graph_.nodes().size());
    for (const CuspArc<Ball>& cusp : found_.near.cusps) {
      Node node = cusp_node(shared_.chart(cusp.chart), cusp, frame_);
      node.kinds.push_back(NodeKind::end_of_overlap);
      move(graph_.add_node(std::move(node)));
    }
    for (const ChartTrace<Ball>& trace : found_.near.chart_traces) {
      if (trace.end >= 0) {
        append(near_arcs(trace, false));
        append(near_arcs(trace, true));
      }
    }
    for (std::size_t i = 0; i < found_.curves.size(); ++i) {
      if (!found_.along_side[i]) {
        append(joined_arcs(found_.curves[i]));
      }
    }
  }

 private:
  /// Where the arcs of a trace end before they are joined to those in the charts.
  void add_gate(const BallPoint<Ball>& gate) {
    ParameterBox box;
    for (std::size_t j = 0; j < 4; ++j) {
      box[j] = gate[j].interval();
    }
    graph_.add_node(landmark_node(system_, frame_, gate, box, {}));
  }

  void move(int id) {
    const Node& node = graph_.node(id);
    ParameterBox box;
    for (std::size_t j = 0; j < 4; ++j) {
      box[j] = from_common_(node.box[j], j);
    }
    graph_.move_node(id, box, from_common_(node.approx));
  }

  /// From the cuspidal point of a trace in the charts on, in one of the two orders.
  std::vector<Arc> near_arcs(const ChartTrace<Ball>& trace, bool exchanged) {
    const std::size_t before = graph_.nodes().size();
    const int end = trace.end < 0 ? -1 : first_cusp_ + trace.end;
    std::vector<Arc> arcs = chart_arcs(graph_, shared_, trace, exchanged, frame_, wanted_, tolerance_,
                                       first_cusp_ + trace.start, end);
    for (std::size_t i = before; i < graph_.nodes().size(); ++i) {
      move(static_cast<int>(i));
    }
    for (Arc& arc : arcs) {
      for (PolylineVertex& vertex : arc.polyline) {
        vertex.parameters = from_common_(vertex.parameters);
      }
    }
    return arcs;
  }

  std::optional<std::vector<Arc>> arcs_to_gate(int landmark) {
    const int first_gate = static_cast<int>(boundary_points_);
    if (landmark < first_gate || landmark >= first_gate + static_cast<int>(found_.near.landmarks.size())) {
      return std::nullopt;
    }
    const auto gate = found_.near.gate(landmark - first_gate);
    return near_arcs(found_.near.chart_traces[gate->trace], gate->exchanged);
  }

  std::vector<Arc> joined_arcs(const AnalysedTrace<Ball>& curve) {
    const auto before = static_cast<int>(graph_.arcs().size());
    append_trace(graph_, curve, found_.landmarks, nodes_of_landmarks(found_.landmarks.size()), frame_,
                 wanted_, tolerance_);
    std::vector<Arc> arcs = graph_.take_arcs(before);
    if (const auto lead = arcs_to_gate(curve.trace.start)) {
      arcs = joined(*lead, std::move(arcs));
    }
    if (auto tail = arcs_to_gate(curve.trace.end)) {
      reverse(*tail);
      arcs = joined(std::move(arcs), std::move(*tail));
    }
    return arcs;
  }

  void append(std::vector<Arc> arcs) {
    for (Arc& arc : arcs) {
      graph_.add_arc(std::move(arc));
    }
  }

  GraphBuilder& graph_;
  const SelfSystem<Ball>& shared_;
  const PairSystem<Ball>& system_;
  const TwoPieceCurves<Ball>& found_;
  const ModelFrame& frame_;
  const std::vector<Parameter>& wanted_;
  double tolerance_;
  std::size_t boundary_points_;
  PairMap from_common_;
  int first_cusp_ = 0;
};

}  // namespace

template <class Ball>
void append_two_pieces(GraphBuilder& graph, const TwoPieces& pieces, const SelfSystem<Ball>& shared,
                       const PairSystem<Ball>& system, const TwoPieceCurves<Ball>& found,
                       const ModelFrame& frame, const std::vector<Parameter>& wanted, double tolerance) {
  TwoPieceGraph<Ball>(graph, pieces, shared, system, found, frame, wanted, tolerance).run();
}

#define EXSECT_INSTANTIATE_TWO_PIECES(Ball)                                                                \
  template void append_two_pieces(GraphBuilder&, const TwoPieces&, const SelfSystem<Ball>&,                \
                                  const PairSystem<Ball>&, const TwoPieceCurves<Ball>&, const ModelFrame&, \
                                  const std::vector<Parameter>&, double);

EXSECT_INSTANTIATE_TWO_PIECES(DoubleBall)
EXSECT_INSTANTIATE_TWO_PIECES(ArbBall<256>)
#undef EXSECT_INSTANTIATE_TWO_PIECES

}  // namespace exsect
