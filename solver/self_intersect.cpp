#include "self_intersect.h"

#include <exsect/geometry/bounding_box.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "self_curves.h"
#include "traced_curves.h"
#include "turning_points.h"

namespace exsect {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFinestTolerance = 1e-12;
constexpr double kCoarseTolerance = 1e-9;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void check(const IntersectOptions& options) {
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance)) {
    throw std::invalid_argument("tolerance must be a positive finite number");
  }
  if (options.max_seconds && !(*options.max_seconds > 0)) {
    throw std::invalid_argument("max_seconds must be positive");
  }
}

/// Origin (with double coordinates) and power of two that bring the patch to unit size.
struct Scaling {
  ModelFrame frame;
  Point origin;
  double extent;
};

Scaling scaling_of(const BezierPatch& x) {
  const BoundingBox box = bounding_box(x);
  Scaling result{};
  for (std::size_t c = 0; c < 3; ++c) {
    result.frame.origin[c] = to_double((box.lower[c] + box.upper[c]) / 2);
    if (!std::isfinite(result.frame.origin[c])) {
      throw std::invalid_argument("control points must lie in the range of doubles");
    }
    result.origin[c] = from_double(result.frame.origin[c]);
  }
  result.extent = to_double(largest_extent(box));
  result.frame.exponent = result.extent > 0 ? std::ilogb(result.extent) + 1 : 0;
  return result;
}

class SelfIntersection {
 public:
  SelfIntersection(const BezierPatch& x, const IntersectOptions& options)
      : x_(x), options_(options), scaling_(scaling_of(x)), stop_([this] { return out_of_time(); }) {}

  IntersectResult run() {
    bool injective = false;
    timed("injectivity", [&] {
      injective = is_quickly_injective({x_, scaling_.origin, scaling_.frame.exponent}, stop_);
    });
    if (!injective) {
      find_curves();
    }
    finish_components(result_.graph);
    result_.status = result_.incomplete.empty() ? Status::complete : Status::incomplete;
    result_.work.milliseconds = milliseconds_since(start_);
    return std::move(result_);
  }

 private:
  bool out_of_time() const {
    return options_.max_seconds && milliseconds_since(start_) > 1000 * *options_.max_seconds;
  }

  template <class Step>
  void timed(const char* step, Step&& body) {
    const auto begin = Clock::now();
    body();
    result_.work.steps[std::string(step) + " ms"] += milliseconds_since(begin);
    if (options_.progress) {
      progress_ += 0.25;
      options_.progress(std::min(progress_, 1.0), step);
    }
  }

  void find_curves() {
    if (out_of_time()) {
      result_.incomplete.push_back({whole_domain(), "the work cap was reached"});
      return;
    }
    timed("exact places", [this] {
      exact_ = {self_boundary(x_), special_cusps(x_), coincident_parameters(x_, x_)};
    });
    if (!exact_.boundary.problems.empty()) {
      result_.incomplete = exact_.boundary.problems;
      return;
    }
    if (!trace_and_build<DoubleBall>(power_of_two(-50), false)) {
      trace_and_build<ArbBall<256>>(power_of_two(-200), true);
    }
  }

  /// One attempt in one arithmetic; false if something is undecided that more precision may decide and `last`
  /// is not set.
  template <class Ball>
  bool trace_and_build(const Rational& width, bool last) {
    const SelfSystem<Ball> system(x_, scaling_.origin, scaling_.frame.exponent);
    SelfCurves<Ball> found;
    timed("tracing", [&] { found = trace_self_curves(system, exact_, width, stop_); });
    if (!found.problems.empty() && !last && !out_of_time()) {
      return false;
    }
    result_.incomplete.insert(result_.incomplete.end(), found.problems.begin(), found.problems.end());
    result_.work.steps["searched boxes"] += static_cast<double>(found.searched_boxes);
    timed("graph", [&] { build_graph(system, found); });
    return true;
  }

  template <class Ball>
  void build_graph(const SelfSystem<Ball>& system, const SelfCurves<Ball>& found) {
    IntersectionGraph& graph = result_.graph;
    const std::size_t boundary = exact_.boundary.points.size();
    for (std::size_t i = 0; i < found.landmarks.size(); ++i) {
      ParameterBox box;
      for (std::size_t j = 0; j < 4; ++j) {
        box[j] = i < boundary ? exact_.boundary.points[i].box()[j] : found.landmarks[i][j].interval();
      }
      const std::vector<Side> sides = i < boundary ? exact_.boundary.points[i].sides() : std::vector<Side>{};
      graph.nodes.push_back(boundary_node(system.pair, scaling_.frame, found.landmarks[i], box, sides));
      graph.nodes.back().id = static_cast<int>(i);
    }
    graph.isolated_points = found.isolated;
    // Vertices are doubles: below the finest tolerance the polylines stay coarse and the result says so.
    const double tolerance = options_.tolerance * scaling_.extent;
    const double used =
        options_.tolerance < kFinestTolerance ? kCoarseTolerance * scaling_.extent : tolerance;
    for (const SelfCurve<Ball>& curve : found.curves) {
      const std::size_t first = graph.arcs.size();
      append_trace(graph, curve.analysed, scaling_.frame, options_.turning, used);
      put_on_side(graph, first, curve.along);
      result_.work.steps["tubes"] += static_cast<double>(curve.analysed.trace.pieces.size());
    }
    attach_cusps(system, found, used);
    for (const Arc& arc : graph.arcs) {
      result_.work.steps["vertices"] += static_cast<double>(arc.polyline.size());
      if (!(arc.error_bound <= tolerance)) {
        result_.incomplete.push_back(
            {graph.nodes[static_cast<std::size_t>(arc.from)].box,
             "the tolerance is below what a polyline in doubles can be proved to keep on the arc from here"});
      }
    }
  }

  /// The arcs from index `first` on lie on the side in both preimages.
  static void put_on_side(IntersectionGraph& graph, std::size_t first, const std::optional<Side>& side) {
    for (std::size_t i = first; side && i < graph.arcs.size(); ++i) {
      graph.arcs[i].place = ArcPlace::patch_boundary;
      for (PolylineVertex& vertex : graph.arcs[i].polyline) {
        vertex.parameters[index(side->parameter)] = side->value;
        vertex.parameters[index(side->parameter) + 2] = side->value;
      }
    }
  }

  /// Arcs that end at a gate are continued to the cuspidal point.
  template <class Ball>
  void attach_cusps(const SelfSystem<Ball>& system, const SelfCurves<Ball>& found, double tolerance) {
    IntersectionGraph& graph = result_.graph;
    const std::size_t first_gate = exact_.boundary.points.size();
    const std::size_t after_gates = found.landmarks.size();
    for (std::size_t k = 0; k < found.cusps.size(); ++k) {
      const CuspArc<Ball>& cusp = found.cusps[k];
      const ChartSystem<Ball>& chart = system.chart(cusp.chart);
      const CuspPolyline line = cusp_polyline(chart, cusp, scaling_.frame, tolerance);
      Node node = cusp_node(chart, cusp, scaling_.frame);
      node.id = static_cast<int>(graph.nodes.size());
      graph.nodes.push_back(node);
      for (Arc& arc : graph.arcs) {
        for (int* end : {&arc.from, &arc.to}) {
          const auto landmark = static_cast<std::size_t>(*end);
          if (landmark >= after_gates || landmark < first_gate || (landmark - first_gate) / 2 != k) {
            continue;
          }
          extend(arc, end == &arc.from, line, (landmark - first_gate) % 2 == 1);
          *end = node.id;
        }
      }
    }
  }

  /// The gate's own vertex is the arc's; `exchange`: the arc is traced in the other order of the pairs.
  static void extend(Arc& arc, bool at_start, const CuspPolyline& line, bool exchange) {
    std::vector<PolylineVertex> added(line.vertices.begin(), line.vertices.end() - 1);
    for (PolylineVertex& vertex : added) {
      if (exchange) {
        vertex.parameters = {vertex.parameters[2], vertex.parameters[3], vertex.parameters[0],
                             vertex.parameters[1]};
      }
    }
    if (at_start) {
      arc.polyline.insert(arc.polyline.begin(), added.begin(), added.end());
    } else {
      arc.polyline.insert(arc.polyline.end(), added.rbegin(), added.rend());
    }
    arc.error_bound = std::max(arc.error_bound, line.error_bound);
  }

  const BezierPatch& x_;
  const IntersectOptions& options_;
  Clock::time_point start_ = Clock::now();
  Scaling scaling_;
  StopRequest stop_;
  ExactPlaces exact_{};
  IntersectResult result_{};
  double progress_ = 0;
};

}  // namespace

IntersectResult self_intersect(const BezierPatch& x, const IntersectOptions& options) {
  check(options);
  return SelfIntersection(x, options).run();
}

}  // namespace exsect
