#include "intersect.h"

#include <exsect/solver/line_patch.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "critical_values.h"
#include "degenerate_patches.h"
#include "model_scale.h"
#include "overlaps.h"
#include "traced_curves.h"

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

class Intersection {
 public:
  Intersection(const BezierPatch& x, const BezierPatch& y, const IntersectOptions& options)
      : x_(x), y_(y), options_(options), scaling_(model_scale(x, y)), stop_([this] {
          return out_of_time();
        }) {
    sweep_.coincident = coincident_parameters(x, y);
  }

  IntersectResult run() {
    timed("boundary points", [this] { find_boundary_points(); });
    timed("turning eliminant", [this] { find_turning_values(); });
    timed("fibres", [this] { compute_fibres(); });
    const bool decided = trace_and_build<DoubleBall>(power_of_two(-50), false);
    if (!decided) {
      trace_and_build<ArbBall<256>>(power_of_two(-200), true);
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
      progress_ += 0.2;
      options_.progress(std::min(progress_, 1.0), step);
    }
  }

  void incomplete(const ParameterBox& where, const std::string& why) {
    result_.incomplete.push_back({where, why});
  }

  /// The points on the eight sides, each kept once: on the first of its sides.
  void find_boundary_points() {
    for (const Parameter p : all_parameters) {
      for (const int value : {0, 1}) {
        if (out_of_time()) {
          incomplete(whole_domain(), "the work cap was reached while boundary points were computed");
          return;
        }
        const LinePoints line = line_points(x_, y_, {p, value});
        const std::string label = std::string(name(p)) + " = " + std::to_string(value);
        ParameterBox where = whole_domain();
        where[index(p)] = {value, value};
        if (line.incomplete) {
          incomplete(where, "the boundary line " + label + ": " + *line.incomplete);
        }
        if (!line.on_patch.empty()) {
          incomplete(where, "the boundary line " + label + " lies on the other patch, in whole or in part");
        }
        for (const CertifiedPoint& point : line.points) {
          if (point.sides().front() == Side{p, value}) {
            sweep_.boundary.push_back(point);
          }
        }
      }
    }
  }

  void find_turning_values() {
    if (out_of_time()) {
      incomplete(whole_domain(), "the work cap was reached before closed curves were excluded");
      return;
    }
    sweep_.turning = choose_sweep(x_, y_).turning;  // without one, closed curves are found by subdivision
  }

  /// Exact fibres at samples between all critical values.
  void compute_fibres() {
    if (!sweep_.turning) {
      return;
    }
    sweep_.samples = sweep_samples(*sweep_.turning, sweep_.boundary);
    for (const Rational& sample : sweep_.samples) {
      if (out_of_time()) {
        incomplete(whole_domain(), "the work cap was reached while fibres were computed");
        return;
      }
      LinePoints fibre = line_points(x_, y_, {sweep_.turning->sweep, sample});
      ParameterBox where = whole_domain();
      where[index(sweep_.turning->sweep)] = {sample, sample};
      if (fibre.incomplete || !fibre.on_patch.empty()) {
        incomplete(where, fibre.incomplete ? *fibre.incomplete : "a parameter line lies on the other patch");
      }
      sweep_.fibres.push_back(std::move(fibre.points));
    }
    result_.work.steps["fibres"] = static_cast<double>(sweep_.fibres.size());
  }

  /// One attempt in one arithmetic; false if something is undecided that more precision may decide and `last`
  /// is not set.
  template <class Ball>
  bool trace_and_build(const Rational& width, bool last) {
    const PairSystem<Ball> system(x_, y_, scaling_.origin, scaling_.frame.exponent);
    Landmarks<Ball> landmarks;
    for (const CertifiedPoint& point : sweep_.boundary) {
      landmarks.push_back(enclose<Ball>(point, width));
    }
    TracedCurves<Ball> traced;
    sweep_.exact = result_.incomplete.empty();
    timed("tracing", [&] { traced = trace_curves(system, landmarks, sweep_, width, stop_); });
    if (!traced.problems.empty() && sweep_.exact && !last) {
      return false;
    }
    result_.incomplete.insert(result_.incomplete.end(), traced.problems.begin(), traced.problems.end());
    result_.work.steps["searched boxes"] += static_cast<double>(traced.searched_boxes);
    timed("graph", [&] { build_graph(system, landmarks, traced); });
    return true;
  }

  template <class Ball>
  void build_graph(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks,
                   const TracedCurves<Ball>& traced) {
    IntersectionGraph& graph = result_.graph;
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
      const CertifiedPoint& point = sweep_.boundary[i];
      graph.nodes.push_back(boundary_node(system, scaling_.frame, landmarks[i], point.box(), point.sides()));
      graph.nodes.back().id = static_cast<int>(i);
    }
    graph.isolated_points = traced.isolated;
    // Vertices are doubles: below the finest tolerance the polylines stay coarse and the result says so.
    const double tolerance = options_.tolerance * scaling_.extent;
    const double used =
        options_.tolerance < kFinestTolerance ? kCoarseTolerance * scaling_.extent : tolerance;
    for (const AnalysedTrace<Ball>& curve : traced.curves) {
      append_trace(graph, curve, scaling_.frame, options_.turning, used);
      result_.work.steps["tubes"] += static_cast<double>(curve.trace.pieces.size());
    }
    for (const Arc& arc : graph.arcs) {
      result_.work.steps["vertices"] += static_cast<double>(arc.polyline.size());
      if (!(arc.error_bound <= tolerance)) {
        incomplete(
            graph.nodes[static_cast<std::size_t>(arc.from)].box,
            "the tolerance is below what a polyline in doubles can be proved to keep on the arc from here");
      }
    }
  }

  const BezierPatch& x_;
  const BezierPatch& y_;
  const IntersectOptions& options_;
  Clock::time_point start_ = Clock::now();
  ModelScale scaling_;
  StopRequest stop_;
  SweepData sweep_;
  IntersectResult result_{};
  double progress_ = 0;
};

}  // namespace

IntersectResult intersect(const BezierPatch& x, const BezierPatch& y, const IntersectOptions& options) {
  check(options);
  if (std::optional<IntersectResult> result = intersect_degenerate(x, y, options)) {
    return std::move(*result);
  }
  if (std::optional<IntersectResult> result = intersect_on_one_surface(x, y, options)) {
    return std::move(*result);
  }
  return Intersection(x, y, options).run();
}

}  // namespace exsect
