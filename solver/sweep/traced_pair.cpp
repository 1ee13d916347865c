#include "sweep/traced_pair.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <type_traits>
#include <utility>

#include "answer/finished_result.h"
#include "answer/graph_builder.h"
#include "answer/parameter_box.h"
#include "line/known_tangent.h"
#include "line/line_points_in.h"
#include "star/star_arc.h"
#include "sweep/boundary_graph.h"
#include "trace/bounded_vertex.h"
#include "trace/enclose.h"
#include "trace/landmark_node.h"
#include "trace/regular_degree.h"

namespace exsect {

namespace {

template <class Ball>
class PairGraph {
 public:
  PairGraph(const TracedPair<Ball>& pair, const BoundaryLines& sides, const Run& run)
      : pair_(pair), sides_(sides), run_(run), incomplete_(pair.incomplete) {}

  void build() {
    const double tolerance = run_.drawn_tolerance(pair_.scale.extent);
    for (const int id : pair_.traced.isolated) {
      graph_.add_isolated(id);
    }
    const std::vector<TraceEnd> ends = add_landmark_nodes();
    BoundaryGraph<Ball> boundary({pair_.x, pair_.y}, pair_.system, pair_.scale.frame, sides_, pair_.stars,
                                 star_nodes_, graph_, incomplete_);
    boundary.add_arcs();
    for (const AnalysedTrace<Ball>& curve : pair_.traced.curves) {
      append_trace(graph_, curve, pair_.landmarks, ends, pair_.scale.frame, run_.turning(), tolerance);
      run_.count("tubes", static_cast<double>(curve.trace.pieces.size()));
    }
    for (const AnalysedContact<Ball>& contact : pair_.traced.contacts) {
      append_contact(graph_, pair_.system, contact, pair_.landmarks, ends, pair_.scale.frame, run_.turning(),
                     tolerance);
    }
    boundary.contract();
    for (const Arc& arc : graph_.arcs()) {
      run_.count("vertices", static_cast<double>(arc.polyline.size()));
    }
  }

  bool is_coarse() const {
    const double tolerance = run_.drawn_tolerance(pair_.scale.extent);
    return std::ranges::any_of(graph_.arcs(),
                               [&](const Arc& arc) { return !(arc.error_bound <= tolerance); });
  }
  bool is_complete() const { return incomplete_.empty() && pair_.traced.problems.empty(); }

  IntersectResult take() {
    incomplete_.insert(incomplete_.end(), pair_.traced.problems.begin(), pair_.traced.problems.end());
    return finished(std::move(graph_), {run_.turning(), RegularDegree(pair_.x, pair_.y)},
                    std::move(incomplete_));
  }

 private:
  int add_node_at(const BallPoint<Ball>& ball, const CertifiedPoint& point, std::size_t own) {
    return graph_.add_node(landmark_node(pair_.system, pair_.scale.frame, ball,
                                         box_apart(point, own, sides_.points), point.sides()));
  }

  /// The nodes of boundary points and stars, and what the landmarks lead to.
  std::vector<TraceEnd> add_landmark_nodes() {
    std::vector<std::optional<int>> star_nodes(pair_.stars.size());
    star_nodes_.assign(pair_.stars.size(), 0);
    std::vector<TraceEnd> ends;
    for (std::size_t i = 0; i < pair_.landmarks.size(); ++i) {
      const LandmarkPoint& landmark = pair_.points[i];
      if (landmark.side == 0) {
        ends.push_back({add_node_at(pair_.landmarks[i], landmark.point, i), std::nullopt});
        if (landmark.star) {
          star_nodes[*landmark.star] = ends.back().node;
        }
        continue;
      }
      ends.push_back({0, std::nullopt});
    }
    for (std::size_t k = 0; k < pair_.stars.size(); ++k) {
      const StarNeighbourhood& star = pair_.stars[k];
      if (!star_nodes[k]) {
        star_nodes[k] =
            add_node_at(enclose<Ball>(star.centre, power_of_two(-100)), star.centre, sides_.points.size());
      }
      star_nodes_[k] = *star_nodes[k];
      if (star.ports.empty() || leaves_sides(star)) {
        classify(*star_nodes[k], star);
      }
      for (std::size_t i = 0; i < pair_.landmarks.size(); ++i) {
        if (pair_.points[i].side != 0 && pair_.points[i].star == k) {
          ends[i] = {*star_nodes[k], approach(star, pair_.points[i])};
        }
      }
    }
    return ends;
  }

  Approach approach(const StarNeighbourhood& star, const LandmarkPoint& port) const {
    const StarArc arc = star_arc(star, {port.point, port.across, port.side});
    Approach result{{}, 0};
    for (const CertifiedPoint& point : arc.vertices) {
      const Node vertex = landmark_node(pair_.system, pair_.scale.frame,
                                        enclose<Ball>(point, power_of_two(-50)), point.box(), {});
      result.vertices.push_back({vertex.approx, vertex.point});
    }
    for (const ParameterBox& hull : arc.hulls) {
      result.bound = larger_bound(result.bound, chord_bound(pair_.system, pair_.scale.frame, hull));
    }
    return result;
  }

  /// The node of a regular point inside both squares with two arcs.
  void add_turning(int node, const StarNeighbourhood& star) {
    const auto turning = turning_parameters(star);
    if (!turning) {
      incomplete_.push_back(
          {graph_.node(node).box, "whether a parameter turns at this point is not decided"});
      return;
    }
    std::vector<Parameter> wrt;
    for (const Parameter p : *turning) {
      if (std::count(run_.turning().begin(), run_.turning().end(), p) > 0) {
        wrt.push_back(p);
      }
    }
    if (!wrt.empty()) {
      graph_.add_kind(node, NodeKind::turning);
      graph_.set_turning(node, std::move(wrt));
    }
  }

  /// The kind of a star's node; an isolated point is listed as such.
  void classify(int node, const StarNeighbourhood& star) {
    const std::size_t degree = star.ports.size();
    if (degree == 0) {
      graph_.add_isolated(node);
    }
    const bool inside = graph_.node(node).on.empty();  // on a side further branches may lie outside
    if (degree < 3 && !is_known_singular(pair_.x, pair_.y, star.centre)) {
      if (inside && degree == 2) {
        add_turning(node, star);
      }
      return;
    }
    graph_.add_kind(node, singular_kind(degree, inside));
  }

  const TracedPair<Ball>& pair_;
  const BoundaryLines& sides_;
  const Run& run_;
  std::vector<Incomplete> incomplete_;
  std::vector<int> star_nodes_;
  GraphBuilder graph_;
};

}  // namespace

double side_tolerance(double tolerance) { return 0.4 * tolerance; }

template <class Ball>
std::optional<IntersectResult> drawn(const TracedPair<Ball>& pair, const Run& run) {
  const double tolerance = run.drawn_tolerance(pair.scale.extent);
  std::optional<BoundaryLines> redrawn_sides;
  if (tolerance != pair.tolerance && !pair.sides.arcs.empty()) {
    redrawn_sides = boundary_lines(pair.x, pair.y, pair.scale, side_tolerance(tolerance), run.stop());
    if (run.out_of_time()) return std::nullopt;
  }
  PairGraph<Ball> graph(pair, redrawn_sides ? *redrawn_sides : pair.sides, run);
  graph.build();
  // The vertices of longer numbers are as near to the curve as doubles can
  // write them.
  const bool precision_may_help = std::is_same_v<Ball, DoubleBall>;
  const bool smaller_stars_may_help = tolerance < pair.tolerance && !pair.stars.empty();
  if ((precision_may_help || smaller_stars_may_help) && graph.is_coarse() && graph.is_complete()) {
    return std::nullopt;
  }
  return graph.take();
}

#define EXSECT_INSTANTIATE_DRAWN(Ball) \
  template std::optional<IntersectResult> drawn(const TracedPair<Ball>&, const Run&);

EXSECT_INSTANTIATE_DRAWN(DoubleBall)
EXSECT_INSTANTIATE_DRAWN(DoubleDoubleBall)
EXSECT_INSTANTIATE_DRAWN(ArbBall<256>)
EXSECT_INSTANTIATE_DRAWN(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_DRAWN

}  // namespace exsect
