// From a curve as a chain of tubes, of any kind, to nodes and arcs with polylines. Internal to solver/.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "answer/graph_builder.h"
#include "trace/arc_polyline.h"
#include "trace/in_domain.h"
#include "trace/trace_graph.h"

namespace exsect {

/// Appends the nodes and arcs of one curve. A Pen draws it; it has
///   Number, contact                the balls of its boxes, and the contact of its arcs
///   curve                          the AnalysedCurve
///   vertex(piece, box)             for the point of the curve in the box, on this piece
///   vertex_at(piece, tau)          for the point at an offset
///   add_chords(line, piece, a, b)  between two offsets, the vertices of which are added by this class
template <class Pen>
class CurveAppender {
 public:
  using Ball = typename Pen::Number;

  CurveAppender(GraphBuilder& graph, const Pen& pen, const Landmarks<Ball>& landmarks,
                const std::vector<TraceEnd>& ends)
      : graph_(graph), pen_(pen), landmarks_(landmarks), ends_(ends) {}

  /// With turning points with respect to `wanted`; with all of them if there is no other node.
  void run(const std::vector<Parameter>& wanted) {
    add_turning_nodes(wanted);
    add_cuts();
    const bool is_closed = pen_.curve.trace.start < 0;
    if (stops_.empty() && is_closed) {
      add_turning_nodes({all_parameters.begin(), all_parameters.end()});
    }
    is_closed ? add_closed() : add_open();
  }

 private:
  /// A place on the curve: piece and offset.
  struct Station {
    std::size_t piece;
    double tau;
  };
  struct Stop {
    int node;
    Station station;
    BoundedVertex vertex;
    const Approach* approach;  // from the vertex to the node; null if the vertex is the node's
  };

  void add_turning_nodes(const std::vector<Parameter>& wanted) {
    for (const TurningPoint<Ball>& point : pen_.curve.turning) {
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
    for (const TraceCut& cut : pen_.curve.cuts) {
      stops_.push_back(landmark_stop(cut.landmark, cut.piece, cut.tau));
    }
    std::stable_sort(stops_.begin(), stops_.end(), [&](const Stop& a, const Stop& b) {
      return a.station.piece != b.station.piece
                 ? a.station.piece < b.station.piece
                 : pen_.curve.trace.pieces[a.station.piece].range.precedes(a.station.tau, b.station.tau);
    });
  }

  Stop turning_stop(const TurningPoint<Ball>& point, const std::vector<Parameter>& wrt) {
    const BoundedVertex vertex = pen_.vertex(point.piece, point.box);
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
    BoundedVertex vertex = pen_.vertex(piece, landmarks_[static_cast<std::size_t>(landmark)]);
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

  void leave_node(ArcPolyline& line, const Stop& stop) const {
    if (stop.approach != nullptr) {
      line.add_vertex(node_vertex(stop));
      std::for_each(stop.approach->vertices.rbegin(), stop.approach->vertices.rend(),
                    [&](const PolylineVertex& vertex) {
                      line.add_vertex({vertex, 0});
                    });
      line.cover(stop.approach->bound);
    }
    line.add_vertex(stop.vertex);
  }

  void enter_node(ArcPolyline& line, const Stop& stop) const {
    line.add_vertex(stop.vertex);
    if (stop.approach != nullptr) {
      for (const PolylineVertex& vertex : stop.approach->vertices) {
        line.add_vertex({vertex, 0});
      }
      line.add_vertex(node_vertex(stop));
      line.cover(stop.approach->bound);
    }
  }

  void add_path(ArcPolyline& line, Station from, Station to) const {
    const auto& pieces = pen_.curve.trace.pieces;
    for (std::size_t p = from.piece; p <= to.piece; ++p) {
      const double a = p == from.piece ? from.tau : pieces[p].range.from();
      const double b = p == to.piece ? to.tau : pieces[p].range.to();
      pen_.add_chords(line, p, a, b);
      if (p != to.piece) line.add_vertex(pen_.vertex_at(p, b));
    }
  }

  void add_arc(const Stop& from, const Stop& to, const std::vector<std::pair<Station, Station>>& paths) {
    ArcPolyline line;
    leave_node(line, from);
    for (std::size_t i = 0; i < paths.size(); ++i) {
      if (i > 0) {  // the seam of a closed curve
        line.add_vertex(pen_.vertex_at(paths[i].first.piece, paths[i].first.tau));
      }
      add_path(line, paths[i].first, paths[i].second);
    }
    enter_node(line, to);
    Arc arc{};
    arc.from = from.node;
    arc.to = to.node;
    arc.place = ArcPlace::interior;
    arc.contact = Pen::contact;
    arc.polyline = line.take_vertices();
    arc.error_bound = line.bound();
    graph_.add_arc(std::move(arc));
  }

  void add_open() {
    const auto& pieces = pen_.curve.trace.pieces;
    stops_.insert(stops_.begin(), landmark_stop(pen_.curve.trace.start, 0, pieces.front().range.from()));
    stops_.push_back(landmark_stop(pen_.curve.trace.end, pieces.size() - 1, pieces.back().range.to()));
    for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
      add_arc(stops_[i], stops_[i + 1], {{stops_[i].station, stops_[i + 1].station}});
    }
  }

  void add_closed() {
    const auto& pieces = pen_.curve.trace.pieces;
    for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
      add_arc(stops_[i], stops_[i + 1], {{stops_[i].station, stops_[i + 1].station}});
    }
    const Station end = {pieces.size() - 1, pieces.back().range.to()};
    const Station begin = {0, pieces.front().range.from()};
    add_arc(stops_.back(), stops_.front(), {{stops_.back().station, end}, {begin, stops_.front().station}});
  }

  GraphBuilder& graph_;
  const Pen& pen_;
  const Landmarks<Ball>& landmarks_;
  const std::vector<TraceEnd>& ends_;
  std::vector<Stop> stops_;
};

}  // namespace exsect
