#include "sweep/intersect_by_sweep.h"

#include <exsect/algebra/rounding_bounds.h>
#include <exsect/solver/line_query.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "answer/finished_result.h"
#include "answer/graph_builder.h"
#include "answer/left_open.h"
#include "answer/model_scale.h"
#include "answer/parameter_box.h"
#include "filter/contact_regions.h"
#include "line/known_tangent.h"
#include "line/line_points_in.h"
#include "side/boundary_lines.h"
#include "side/collapsed_line.h"
#include "side/common_pole.h"
#include "star/pinch_points.h"
#include "star/singular_points.h"
#include "star/star_arc.h"
#include "sweep/boundary_graph.h"
#include "sweep/traced_curves.h"
#include "trace/bounded_vertex.h"
#include "trace/enclose.h"
#include "trace/landmark_node.h"
#include "trace/regular_degree.h"

namespace exsect {

namespace {

/// Of boxes of landmarks: polylines in doubles do not get better beyond.
Rational vertex_width() { return power_of_two(-200); }

class Intersection {
 public:
  Intersection(const BezierPatch& x, const BezierPatch& y, const Run& run, ExactPair& pair)
      : x_(x), y_(y), run_(run), pair_(pair), scaling_(model_scale(x, y)), sweep_{pair} {
    sweep_.settled = [this](const SearchRegion& region) {
      if (!contacts_) contacts_.emplace(x_, y_);
      return contacts_->settles(region);
    };
  }

  IntersectResult run() {
    timed("boundary points", [this] { find_boundary_points(); });
    timed("turning eliminant", [this] { find_turning_values(); });
    timed("fibres", [this] { compute_fibres(); });
    sweep_.quick = true;
    if (!trace_and_build<DoubleBall>(power_of_two(-50), false)) {
      timed("singular points", [this] { find_stars(); });
      const bool again = !sweep_.stars.empty() || cut_short_;
      sweep_.quick = false;
      if ((!again || !trace_and_build<DoubleBall>(power_of_two(-50), false)) &&
          !trace_and_build<DoubleDoubleBall>(power_of_two(-100), false) &&
          !trace_and_build<ArbBall<256>>(vertex_width(), false)) {
        trace_and_build<ArbBall<1024>>(power_of_two(-700), true);
      }
    }
    return finished(std::move(graph_), {run_.turning(), RegularDegree(x_, y_)},
                    std::move(result_.incomplete));
  }

 private:
  template <class Step>
  void timed(const char* step, Step&& body) {
    run_.timed(step, std::forward<Step>(body));
  }

  void incomplete(const ParameterBox& where, const std::string& why) {
    result_.incomplete.push_back({where, why});
  }

  void find_boundary_points() {
    sides_ = boundary_lines(x_, y_, scaling_, 0.4 * run_.drawn_tolerance(scaling_.extent), stop_);
    result_.incomplete = sides_.incomplete;
    on_side_arc_.assign(sides_.points.size(), false);
    for (const SideArc& arc : sides_.arcs) {
      on_side_arc_[arc.from] = on_side_arc_[arc.to] = true;
    }
    for (const CommonPole& pole : sides_.poles) {
      for (std::size_t i = 0; i < sides_.points.size(); ++i) {
        on_side_arc_[i] = on_side_arc_[i] || is_on(sides_.points[i], pole);
      }
    }
    for (std::size_t i = 0; i < sides_.points.size(); ++i) {
      sweep_.landmarks.push_back({sides_.points[i], std::nullopt, 0, Parameter::u, on_side_arc_[i]});
    }
  }

  void find_turning_values() {
    if (run_.out_of_time()) {
      result_.incomplete.push_back(
          out_of_time(whole_domain(), "the work cap was reached before closed curves were excluded"));
      return;
    }
    sweep_.turning = pair_.choice().turning;  // without one, closed curves are found by subdivision
  }

  /// Exact fibres at samples between all critical values, where no parameter is that of a pinch point.
  void compute_fibres() {
    if (!sweep_.turning) {
      return;
    }
    std::vector<CertifiedPoint> avoided = sides_.points;
    avoided.insert(avoided.end(), pinches_.begin(), pinches_.end());
    std::vector<Rational> samples = sweep_samples(*sweep_.turning, avoided);
    if (samples == sweep_.samples) {
      return;
    }
    sweep_.samples = std::move(samples);
    sweep_.fibres.clear();
    for (const Rational& sample : sweep_.samples) {
      if (run_.out_of_time()) {
        result_.incomplete.push_back(
            out_of_time(whole_domain(), "the work cap was reached while fibres were computed"));
        return;
      }
      const LinePoints& fibre = pair_.fibre({sweep_.turning->sweep, sample});
      ParameterBox where = whole_domain();
      where[index(sweep_.turning->sweep)] = {sample, sample};
      if (fibre.incomplete || !fibre.on_patch.empty()) {
        incomplete(where, fibre.incomplete ? *fibre.incomplete : "a parameter line lies on the other patch");
      }
      sweep_.fibres.push_back(fibre.points);
    }
    run_.count("fibres", static_cast<double>(sweep_.fibres.size()));
  }

  /// Proves neighbourhoods of the singular points; their ports become landmarks.
  void find_stars() {
    pinches_ = pinch_points(x_, y_);
    if (!pinches_.empty()) {
      compute_fibres();
    }
    const SingularPointQuery query = {
        pair_,
        {sides_.points, sweep_.turning ? sweep_.turning->sweep : Parameter::u, sweep_.samples},
        on_side_arc_,
        pinches_,
        std::ldexp(run_.drawn_tolerance(scaling_.extent), static_cast<int>(-scaling_.frame.exponent))};
    const PairSystem<ArbBall<256>> system(x_, y_, scaling_.origin, scaling_.frame.exponent);
    sweep_.stars = singular_stars(query, system);
    for (std::size_t k = 0; k < sweep_.stars.size(); ++k) {
      const StarNeighbourhood& star = sweep_.stars[k];
      for (LandmarkPoint& landmark : sweep_.landmarks) {
        if (landmark.side == 0 && surely_lies_in(landmark.point, star.box)) {
          landmark.star = k;
        }
      }
      for (const Port& port : star.ports) {
        if (port.point.sides().empty()) {  // else the arc lies on a side
          sweep_.landmarks.push_back({port.point, k, port.side, port.across, false});
        }
      }
    }
  }

  /// One attempt in one arithmetic; false if something is undecided that more precision may decide and `last`
  /// is not set.
  template <class Ball>
  bool trace_and_build(const Rational& width, bool last) {
    const PairSystem<Ball> system(x_, y_, scaling_.origin, scaling_.frame.exponent);
    Landmarks<Ball> landmarks;
    for (const LandmarkPoint& landmark : sweep_.landmarks) {
      landmarks.push_back(enclose<Ball>(landmark.point, width));
    }
    TracedCurves<Ball> traced;
    sweep_.exact = result_.incomplete.empty();
    timed("tracing", [&] { traced = trace_curves(system, landmarks, sweep_, width, stop_); });
    cut_short_ = traced.cut_short;
    // What a search has left open in balls of many bits stays open with more.
    const bool searched_in_vain = traced.searched_boxes > 0 && width <= vertex_width();
    if (!traced.problems.empty() && sweep_.exact && !last && !searched_in_vain) {
      return false;
    }
    timed("graph", [&] { build_graph(system, landmarks, traced); });
    // The vertices of the others are as near to the curve as doubles can write them.
    const bool precision_may_help = std::is_same_v<Ball, DoubleBall> && traced.problems.empty();
    if (precision_may_help && is_coarse() && result_.incomplete.empty()) {
      graph_ = {};
      return false;
    }
    result_.incomplete.insert(result_.incomplete.end(), traced.problems.begin(), traced.problems.end());
    run_.count("searched boxes", static_cast<double>(traced.searched_boxes));
    return true;
  }

  bool is_coarse() const {
    const double tolerance = run_.drawn_tolerance(scaling_.extent);
    return std::ranges::any_of(graph_.arcs(),
                               [&](const Arc& arc) { return !(arc.error_bound <= tolerance); });
  }

  /// The nodes of boundary points and stars, and what the landmarks lead to.
  template <class Ball>
  std::vector<TraceEnd> add_landmark_nodes(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks) {
    std::vector<std::optional<int>> star_nodes(sweep_.stars.size());
    star_nodes_.assign(sweep_.stars.size(), 0);
    const auto add = [&](const BallPoint<Ball>& ball, const CertifiedPoint& point, std::size_t own) {
      return graph_.add_node(
          landmark_node(system, scaling_.frame, ball, box_apart(point, own, sides_.points), point.sides()));
    };
    std::vector<TraceEnd> ends;
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
      const LandmarkPoint& landmark = sweep_.landmarks[i];
      if (landmark.side == 0) {
        ends.push_back({add(landmarks[i], landmark.point, i), std::nullopt});
        if (landmark.star) {
          star_nodes[*landmark.star] = ends.back().node;
        }
        continue;
      }
      ends.push_back({0, std::nullopt});
    }
    for (std::size_t k = 0; k < sweep_.stars.size(); ++k) {
      const StarNeighbourhood& star = sweep_.stars[k];
      if (!star_nodes[k]) {
        star_nodes[k] =
            add(enclose<Ball>(star.centre, power_of_two(-100)), star.centre, sides_.points.size());
      }
      star_nodes_[k] = *star_nodes[k];
      if (star.ports.empty() || leaves_sides(star)) {
        classify(*star_nodes[k], star);
      }
      for (std::size_t i = 0; i < landmarks.size(); ++i) {
        if (sweep_.landmarks[i].side != 0 && sweep_.landmarks[i].star == k) {
          ends[i] = {*star_nodes[k], approach(system, star, sweep_.landmarks[i])};
        }
      }
    }
    return ends;
  }

  template <class Ball>
  Approach approach(const PairSystem<Ball>& system, const StarNeighbourhood& star,
                    const LandmarkPoint& port) const {
    const StarArc arc = star_arc(star, {port.point, port.across, port.side});
    Approach result{{}, 0};
    for (const CertifiedPoint& point : arc.vertices) {
      const Node vertex =
          landmark_node(system, scaling_.frame, enclose<Ball>(point, power_of_two(-50)), point.box(), {});
      result.vertices.push_back({vertex.approx, vertex.point});
    }
    for (const ParameterBox& hull : arc.hulls) {
      result.bound = larger_bound(result.bound, chord_bound(system, scaling_.frame, hull));
    }
    return result;
  }

  /// The node of a regular point inside both squares with two arcs.
  void add_turning(int node, const StarNeighbourhood& star) {
    const auto turning = turning_parameters(star);
    if (!turning) {
      incomplete(graph_.node(node).box, "whether a parameter turns at this point is not decided");
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
    if (degree < 3 && !is_known_singular(x_, y_, star.centre)) {
      if (inside && degree == 2) {
        add_turning(node, star);
      }
      return;
    }
    graph_.add_kind(node, degree == 0             ? NodeKind::touch
                          : inside && degree == 2 ? NodeKind::cusp
                                                  : NodeKind::crossing);
  }

  template <class Ball>
  void build_graph(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks,
                   const TracedCurves<Ball>& traced) {
    for (const int id : traced.isolated) {
      graph_.add_isolated(id);
    }
    const std::vector<TraceEnd> ends = add_landmark_nodes(system, landmarks);
    BoundaryGraph<Ball> boundary({x_, y_}, system, scaling_.frame, sides_, sweep_.stars, star_nodes_, graph_,
                                 result_.incomplete);
    boundary.add_arcs();
    for (const AnalysedTrace<Ball>& curve : traced.curves) {
      append_trace(graph_, curve, landmarks, ends, scaling_.frame, run_.turning(),
                   run_.drawn_tolerance(scaling_.extent));
      run_.count("tubes", static_cast<double>(curve.trace.pieces.size()));
    }
    for (const AnalysedContact<Ball>& contact : traced.contacts) {
      append_contact(graph_, system, contact, landmarks, ends, scaling_.frame, run_.turning(),
                     run_.drawn_tolerance(scaling_.extent));
    }
    boundary.contract();
    for (const Arc& arc : graph_.arcs()) {
      run_.count("vertices", static_cast<double>(arc.polyline.size()));
    }
  }

  const BezierPatch& x_;
  const BezierPatch& y_;
  const Run& run_;
  ExactPair& pair_;
  ModelScale scaling_;
  StopRequest stop_ = run_.stop();
  SweepData sweep_;
  BoundaryLines sides_;
  std::optional<ContactRegions> contacts_;  // once asked for
  std::vector<bool> on_side_arc_;           // per point
  std::vector<CertifiedPoint> pinches_;
  std::vector<int> star_nodes_;
  GraphBuilder graph_;
  IntersectResult result_{};
  bool cut_short_ = false;  // the last attempt's searches were, and something is left
};

}  // namespace

IntersectResult intersect_by_sweep(const BezierPatch& x, const BezierPatch& y, const Run& run,
                                   ExactPair& pair) {
  return Intersection(x, y, run, pair).run();
}

}  // namespace exsect
