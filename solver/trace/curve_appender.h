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

/// A place on a curve: piece and offset.
struct CurveStation {
  std::size_t piece;
  double tau;
};

/// Where an arc ends.
struct CurveStop {
  int node;
  CurveStation station;
  BoundedVertex vertex;
  const Approach* approach = nullptr;  // from the vertex to the node; null if the vertex is the node's
};

/// Appends the nodes and arcs of one curve. A Pen draws it; it has
///   Number, contact                the balls of its boxes, and the contact of its arcs
///   curve                          with its turning points and cuts
///   exchanged                      true: parameters u, v, r, s of the turning points are r, s, u, v
///   pieces()                       of the curve, in order
///   pair(piece, box)               the parameters (u,v,r,s) of a turning point's box
///   vertex(piece, box)             for the point of the curve in the box, on this piece
///   vertex_at(piece, tau)          for the point at an offset
///   add_chords(line, piece, a, b)  between two offsets, the vertices of which are added by this class
template <class Pen>
class CurveAppender {
 public:
  using Ball = typename Pen::Number;

  CurveAppender(GraphBuilder& graph, const Pen& pen) : graph_(graph), pen_(pen) {}

  void add_turning_nodes(const std::vector<Parameter>& wanted) {
    for (const TurningPoint<Ball>& point : pen_.curve.turning) {
      std::vector<Parameter> wrt;
      for (const Parameter p : all_parameters) {
        const bool turns = turns_in(point, pen_.exchanged ? (index(p) + 2) % 4 : index(p));
        if (turns && std::count(wanted.begin(), wanted.end(), p) > 0) {
          wrt.push_back(p);
        }
      }
      if (!wrt.empty()) {
        stops_.push_back(turning_stop(point, wrt));
      }
    }
  }

  /// At the curve's cuts; `stop_at(cut)` is where the arcs end.
  template <class StopAt>
  void add_cuts(const StopAt& stop_at) {
    for (const TraceCut& cut : pen_.curve.cuts) {
      stops_.push_back(stop_at(cut));
    }
    std::stable_sort(stops_.begin(), stops_.end(), [&](const CurveStop& a, const CurveStop& b) {
      return a.station.piece != b.station.piece
                 ? a.station.piece < b.station.piece
                 : pen_.pieces()[a.station.piece].range.precedes(a.station.tau, b.station.tau);
    });
  }

  /// The arcs of an open curve.
  void add_open(const CurveStop& first, const CurveStop& last) {
    stops_.insert(stops_.begin(), first);
    stops_.push_back(last);
    add_arcs();
  }

  /// The arcs of a closed curve, with all turning points if there is no other node.
  void add_closed() {
    if (stops_.empty()) {
      add_turning_nodes({all_parameters.begin(), all_parameters.end()});
    }
    add_arcs();
    const auto& pieces = pen_.pieces();
    const CurveStation end = {pieces.size() - 1, pieces.back().range.to()};
    const CurveStation begin = {0, pieces.front().range.from()};
    add_arc(stops_.back(), stops_.front(), {{stops_.back().station, end}, {begin, stops_.front().station}});
  }

 private:
  CurveStop turning_stop(const TurningPoint<Ball>& point, const std::vector<Parameter>& wrt) {
    const BoundedVertex vertex = pen_.vertex(point.piece, point.box);
    const BallPoint<Ball> pair = pen_.pair(point.piece, point.box);
    Node node{};
    node.kinds = {NodeKind::turning};
    node.wrt = wrt;
    for (std::size_t j = 0; j < 4; ++j) {
      node.box[j] = in_domain(pair[j].interval());
    }
    node.approx = vertex.vertex.parameters;
    node.point = vertex.vertex.point;
    return {graph_.add_node(std::move(node)), {point.piece, 0.5 * (point.from + point.to)}, vertex};
  }

  BoundedVertex node_vertex(const CurveStop& stop) const {
    const Node& node = graph_.node(stop.node);
    return {{node.approx, node.point}, 0};
  }

  void leave_node(ArcPolyline& line, const CurveStop& stop) const {
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

  void enter_node(ArcPolyline& line, const CurveStop& stop) const {
    line.add_vertex(stop.vertex);
    if (stop.approach != nullptr) {
      for (const PolylineVertex& vertex : stop.approach->vertices) {
        line.add_vertex({vertex, 0});
      }
      line.add_vertex(node_vertex(stop));
      line.cover(stop.approach->bound);
    }
  }

  void add_path(ArcPolyline& line, CurveStation from, CurveStation to) const {
    const auto& pieces = pen_.pieces();
    for (std::size_t p = from.piece; p <= to.piece; ++p) {
      const double a = p == from.piece ? from.tau : pieces[p].range.from();
      const double b = p == to.piece ? to.tau : pieces[p].range.to();
      pen_.add_chords(line, p, a, b);
      if (p != to.piece) line.add_vertex(pen_.vertex_at(p, b));
    }
  }

  void add_arc(const CurveStop& from, const CurveStop& to,
               const std::vector<std::pair<CurveStation, CurveStation>>& paths) {
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

  void add_arcs() {
    for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
      add_arc(stops_[i], stops_[i + 1], {{stops_[i].station, stops_[i + 1].station}});
    }
  }

  GraphBuilder& graph_;
  const Pen& pen_;
  std::vector<CurveStop> stops_;
};

/// Appends a curve between landmarks, or a closed one, as append_trace() does.
template <class Pen>
void append_curve(GraphBuilder& graph, const Pen& pen, const Landmarks<typename Pen::Number>& landmarks,
                  const std::vector<TraceEnd>& ends, const std::vector<Parameter>& wanted) {
  const auto stop_at = [&](int landmark, std::size_t piece, double tau) -> CurveStop {
    const TraceEnd& end = ends[static_cast<std::size_t>(landmark)];
    BoundedVertex vertex = pen.vertex(piece, landmarks[static_cast<std::size_t>(landmark)]);
    if (!end.approach) {
      const Node& node = graph.node(end.node);
      vertex.vertex = {node.approx, node.point};
      vertex.error *= 2;  // the node's own vertex stands for the same box
    }
    return {end.node, {piece, tau}, vertex, end.approach ? &*end.approach : nullptr};
  };
  CurveAppender appender(graph, pen);
  appender.add_turning_nodes(wanted);
  appender.add_cuts([&](const TraceCut& cut) { return stop_at(cut.landmark, cut.piece, cut.tau); });
  const auto& trace = pen.curve.trace;
  if (trace.start < 0) return appender.add_closed();
  appender.add_open(stop_at(trace.start, 0, trace.pieces.front().range.from()),
                    stop_at(trace.end, trace.pieces.size() - 1, trace.pieces.back().range.to()));
}

}  // namespace exsect
