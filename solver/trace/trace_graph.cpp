#include "trace/trace_graph.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "answer/chord_count.h"
#include "trace/bounded_vertex.h"
#include "trace/in_domain.h"
#include "trace/tube_points.h"

namespace exsect {

namespace {

template <class Ball>
BoundedVertex to_vertex(const Tube<Ball>& tube, const BallPoint<Ball>& parameters, const ModelFrame& frame) {
  return bounded_vertex(parameters, space_point(tube, parameters), frame);
}

/// Of the parameters of a vertex, which are rounded to doubles.
constexpr double kVertexRadius = 0x1p-60;

/// A place on the trace: piece and offset.
struct Station {
  std::size_t piece;
  double tau;
};

/// Collects the polyline of one arc and its proved bound.
template <class Ball>
class PolylineBuilder {
 public:
  PolylineBuilder(const Trace<Ball>& trace, const ModelFrame& frame, double tolerance)
      : trace_(trace), frame_(frame), tolerance_(tolerance) {}

  void add_vertex(const BoundedVertex& v) {
    vertices_.push_back(v.vertex);
    vertex_error_ = larger_bound(vertex_error_, v.error);
  }

  /// Chords on one piece, from offset a (whose vertex is already there) to offset b; the vertex at b is added
  /// if `with_end`. X is twice differentiable on the tube, so a chord over an offset step h deviates by at
  /// most K h^2 / 8 from the curve over the same offsets, K the tube's bound of |X''|.
  void add_piece(std::size_t piece, double a, double b, bool with_end) {
    const Tube<Ball>& tube = trace_.pieces[piece].tube;
    const double k = std::ldexp(tube.space_second_derivative, static_cast<int>(frame_.exponent));
    const double length = std::fabs(b - a) * kSlack;
    const double wanted = std::ceil(length * std::sqrt(k / (8 * 0.9 * tolerance_)));
    const int n = chord_count(wanted);
    const double step = length / n;
    chord_error_ = larger_bound(chord_error_, k * step * step / 8 * kSlack);
    for (int i = 1; i <= (with_end ? n : n - 1); ++i) {
      const double tau = i == n ? b : a + (b - a) * (static_cast<double>(i) / n);
      add_vertex(to_vertex(tube, point_at(tube, tau, kVertexRadius), frame_));
    }
  }

  void add_path(Station from, Station to) {
    for (std::size_t p = from.piece; p <= to.piece; ++p) {
      const double a = p == from.piece ? from.tau : trace_.pieces[p].range.from();
      const double b = p == to.piece ? to.tau : trace_.pieces[p].range.to();
      add_piece(p, a, b, p != to.piece);
    }
  }

  std::vector<PolylineVertex> take_vertices() { return std::move(vertices_); }
  /// A chord inside a star's box stands for an arc inside it.
  void cover(double bound) { chord_error_ = larger_bound(chord_error_, bound); }

  /// The polyline's end offsets, joints and vertices stand for true points within vertex_error; twice,
  /// because the true end of an arc may be anywhere in its node's box.
  double bound() const { return (chord_error_ + 2 * vertex_error_) * kSlack; }

 private:
  const Trace<Ball>& trace_;
  const ModelFrame& frame_;
  double tolerance_;
  std::vector<PolylineVertex> vertices_;
  double vertex_error_ = 0;
  double chord_error_ = 0;
};

template <class Ball>
class TraceAppender {
 public:
  TraceAppender(GraphBuilder& graph, const AnalysedTrace<Ball>& curve, const Landmarks<Ball>& landmarks,
                const std::vector<TraceEnd>& ends, const ModelFrame& frame, double tolerance)
      : graph_(graph),
        curve_(curve),
        landmarks_(landmarks),
        ends_(ends),
        frame_(frame),
        tolerance_(tolerance) {}

  void run(const std::vector<Parameter>& wanted) {
    add_turning_nodes(wanted);
    add_cuts();
    if (stops_.empty() && curve_.trace.start < 0) {
      add_turning_nodes({all_parameters.begin(), all_parameters.end()});
    }
    curve_.trace.start < 0 ? add_closed() : add_open();
  }

 private:
  struct Stop {
    int node;
    Station station;
    BoundedVertex vertex;
    const Approach* approach;  // from the vertex to the node; null if the vertex is the node's
  };

  void add_turning_nodes(const std::vector<Parameter>& wanted) {
    for (const TurningPoint<Ball>& point : curve_.turning) {
      std::vector<Parameter> wrt;
      for (const Parameter p : all_parameters) {
        const bool turns = std::count(point.parameters.begin(), point.parameters.end(), index(p)) > 0;
        if (turns && std::count(wanted.begin(), wanted.end(), p) > 0) {
          wrt.push_back(p);
        }
      }
      if (!wrt.empty()) {
        stops_.push_back(turning_stop(point, wrt));
      }
    }
  }

  void add_cuts() {
    for (const TraceCut& cut : curve_.cuts) {
      stops_.push_back(landmark_stop(cut.landmark, cut.piece, cut.tau));
    }
    std::stable_sort(stops_.begin(), stops_.end(), [&](const Stop& a, const Stop& b) {
      return a.station.piece != b.station.piece
                 ? a.station.piece < b.station.piece
                 : curve_.trace.pieces[a.station.piece].range.precedes(a.station.tau, b.station.tau);
    });
  }

  Stop turning_stop(const TurningPoint<Ball>& point, const std::vector<Parameter>& wrt) {
    const BoundedVertex vertex = to_vertex(curve_.trace.pieces[point.piece].tube, point.box, frame_);
    Node node{};
    node.kinds = {NodeKind::turning};
    node.wrt = wrt;
    for (std::size_t j = 0; j < 4; ++j) {
      node.box[j] = in_domain(point.box[j].interval());
    }
    node.approx = vertex.vertex.parameters;
    node.point = vertex.vertex.point;
    return {graph_.add_node(std::move(node)), {point.piece, 0.5 * (point.from + point.to)}, vertex, nullptr};
  }

  Stop landmark_stop(int landmark, std::size_t piece, double tau) const {
    const TraceEnd& end = ends_[static_cast<std::size_t>(landmark)];
    const Tube<Ball>& tube = curve_.trace.pieces[piece].tube;
    BoundedVertex vertex = to_vertex(tube, landmarks_[static_cast<std::size_t>(landmark)], frame_);
    if (!end.approach) {
      const Node& node = graph_.node(end.node);
      vertex.vertex = {node.approx, node.point};
      vertex.error *= 2;  // the node's own vertex stands for the same box
    }
    return {end.node, {piece, tau}, vertex, end.approach ? &*end.approach : nullptr};
  }

  BoundedVertex node_vertex(const Stop& stop) const {
    const Node& node = graph_.node(stop.node);
    return {{node.approx, node.point}, 0};
  }

  void leave_node(PolylineBuilder<Ball>& builder, const Stop& stop) const {
    if (stop.approach != nullptr) {
      builder.add_vertex(node_vertex(stop));
      std::for_each(stop.approach->vertices.rbegin(), stop.approach->vertices.rend(),
                    [&](const PolylineVertex& vertex) {
                      builder.add_vertex({vertex, 0});
                    });
      builder.cover(stop.approach->bound);
    }
    builder.add_vertex(stop.vertex);
  }

  void enter_node(PolylineBuilder<Ball>& builder, const Stop& stop) const {
    builder.add_vertex(stop.vertex);
    if (stop.approach != nullptr) {
      for (const PolylineVertex& vertex : stop.approach->vertices) {
        builder.add_vertex({vertex, 0});
      }
      builder.add_vertex(node_vertex(stop));
      builder.cover(stop.approach->bound);
    }
  }

  void add_arc(const Stop& from, const Stop& to, const std::vector<std::pair<Station, Station>>& paths) {
    PolylineBuilder<Ball> builder(curve_.trace, frame_, tolerance_);
    leave_node(builder, from);
    for (std::size_t i = 0; i < paths.size(); ++i) {
      if (i > 0) {  // the seam of a closed curve
        const Tube<Ball>& tube = curve_.trace.pieces[paths[i].first.piece].tube;
        builder.add_vertex(to_vertex(tube, point_at(tube, paths[i].first.tau, kVertexRadius), frame_));
      }
      builder.add_path(paths[i].first, paths[i].second);
    }
    enter_node(builder, to);
    Arc arc{};
    arc.from = from.node;
    arc.to = to.node;
    arc.place = ArcPlace::interior;
    arc.contact = Contact::transversal;
    arc.polyline = builder.take_vertices();
    arc.error_bound = builder.bound();
    graph_.add_arc(std::move(arc));
  }

  void add_open() {
    const auto& pieces = curve_.trace.pieces;
    stops_.insert(stops_.begin(), landmark_stop(curve_.trace.start, 0, pieces.front().range.from()));
    stops_.push_back(landmark_stop(curve_.trace.end, pieces.size() - 1, pieces.back().range.to()));
    for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
      add_arc(stops_[i], stops_[i + 1], {{stops_[i].station, stops_[i + 1].station}});
    }
  }

  void add_closed() {
    const auto& pieces = curve_.trace.pieces;
    for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
      add_arc(stops_[i], stops_[i + 1], {{stops_[i].station, stops_[i + 1].station}});
    }
    const Station end = {pieces.size() - 1, pieces.back().range.to()};
    const Station begin = {0, pieces.front().range.from()};
    add_arc(stops_.back(), stops_.front(), {{stops_.back().station, end}, {begin, stops_.front().station}});
  }

  GraphBuilder& graph_;
  const AnalysedTrace<Ball>& curve_;
  const Landmarks<Ball>& landmarks_;
  const std::vector<TraceEnd>& ends_;
  const ModelFrame& frame_;
  double tolerance_;
  std::vector<Stop> stops_;
};

}  // namespace

template <class Ball>
void append_trace(GraphBuilder& graph, const AnalysedTrace<Ball>& curve, const Landmarks<Ball>& landmarks,
                  const std::vector<TraceEnd>& ends, const ModelFrame& frame,
                  const std::vector<Parameter>& wanted, double tolerance) {
  TraceAppender<Ball>(graph, curve, landmarks, ends, frame, tolerance).run(wanted);
}

std::vector<TraceEnd> nodes_of_landmarks(std::size_t count) {
  std::vector<TraceEnd> ends;
  for (std::size_t i = 0; i < count; ++i) {
    ends.push_back({static_cast<int>(i), std::nullopt});
  }
  return ends;
}

#define EXSECT_INSTANTIATE_TRACE_GRAPH(Ball)                                                                 \
  template void append_trace(GraphBuilder&, const AnalysedTrace<Ball>&, const Landmarks<Ball>&,              \
                             const std::vector<TraceEnd>&, const ModelFrame&, const std::vector<Parameter>&, \
                             double);

EXSECT_INSTANTIATE_TRACE_GRAPH(DoubleBall)
EXSECT_INSTANTIATE_TRACE_GRAPH(DoubleDoubleBall)
EXSECT_INSTANTIATE_TRACE_GRAPH(ArbBall<256>)
EXSECT_INSTANTIATE_TRACE_GRAPH(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_TRACE_GRAPH

}  // namespace exsect
