#include "intersect.h"

#include <exsect/solver/line_patch.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "critical_values.h"
#include "graph_builder.h"

namespace exsect {

namespace {

using Clock = std::chrono::steady_clock;

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

/// Origin (with double coordinates) and power of two that bring both patches to unit size; `extent` is the
/// largest extent of the common bounding box.
struct Scaling {
  ModelFrame frame;
  Point origin;
  double extent;
};

Scaling scaling_of(const BezierPatch& x, const BezierPatch& y) {
  Scaling result{};
  double largest = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    Rational lower = x.net()[0][0][c];
    Rational upper = lower;
    for (const BezierPatch* patch : {&x, &y}) {
      for (const auto& row : patch->net()) {
        for (const Point& p : row) {
          lower = std::min(lower, p[c]);
          upper = std::max(upper, p[c]);
        }
      }
    }
    result.frame.origin[c] = to_double((lower + upper) / 2);
    if (!std::isfinite(result.frame.origin[c])) {
      throw std::invalid_argument("control points must lie in the range of doubles");
    }
    result.origin[c] = from_double(result.frame.origin[c]);
    largest = std::max(largest, to_double(upper - lower));
  }
  result.extent = largest;
  result.frame.exponent = largest > 0 ? std::ilogb(largest) + 1 : 0;
  return result;
}

ParameterBox around(const std::array<double, 4>& where) {
  ParameterBox box;
  for (std::size_t j = 0; j < 4; ++j) {
    const double centre = std::isfinite(where[j]) ? where[j] : 0.5;
    const Rational low = from_double(centre) - power_of_two(-20);
    const Rational high = from_double(centre) + power_of_two(-20);
    box[j] = {std::max<Rational>(low, 0), std::min<Rational>(high, 1)};
  }
  return box;
}

ParameterBox whole_domain() { return {{{0, 1}, {0, 1}, {0, 1}, {0, 1}}}; }

/// The traced curves of one attempt in one arithmetic, and what it could not decide.
template <class Ball>
struct TraceSet {
  std::vector<AnalysedTrace<Ball>> curves;
  std::vector<int> isolated;  // landmarks where no curve enters the domain
  std::vector<Incomplete> problems;
};

class Intersection {
 public:
  Intersection(const BezierPatch& x, const BezierPatch& y, const IntersectOptions& options)
      : x_(x),
        y_(y),
        options_(options),
        scaling_(scaling_of(x, y)),
        coincident_(coincident_parameters(x, y)),
        stop_([this] { return out_of_time(); }) {}

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
            boundary_.push_back(point);
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
    SweepChoice choice = choose_sweep(x_, y_);
    turning_ = std::move(choice.turning);
    if (!turning_) {
      incomplete(whole_domain(), "closed curves and singular points are not excluded: " + choice.why);
    }
  }

  /// Exact fibres at samples between all critical values.
  void compute_fibres() {
    if (!turning_) {
      return;
    }
    samples_ = sweep_samples(*turning_, boundary_);
    for (const Rational& sample : samples_) {
      if (out_of_time()) {
        incomplete(whole_domain(), "the work cap was reached while fibres were computed");
        return;
      }
      LinePoints fibre = line_points(x_, y_, {turning_->sweep, sample});
      ParameterBox where = whole_domain();
      where[index(turning_->sweep)] = {sample, sample};
      if (fibre.incomplete || !fibre.on_patch.empty()) {
        incomplete(where, fibre.incomplete ? *fibre.incomplete : "a parameter line lies on the other patch");
      }
      fibres_.push_back(std::move(fibre.points));
    }
    result_.work.steps["fibres"] = static_cast<double>(fibres_.size());
  }

  /// One attempt; returns false (and changes nothing) if something is undecided and `last` is not set.
  template <class Ball>
  bool trace_and_build(const Rational& width, bool last) {
    const PairSystem<Ball> system(x_, y_, scaling_.origin, scaling_.frame.exponent);
    Landmarks<Ball> landmarks;
    for (const CertifiedPoint& point : boundary_) {
      landmarks.push_back(enclose<Ball>(point.refined_to(width)));
    }
    TraceSet<Ball> set;
    timed("tracing", [&] { trace_all(system, landmarks, width, set); });
    if (!set.problems.empty() && !last) {
      return false;
    }
    result_.incomplete.insert(result_.incomplete.end(), set.problems.begin(), set.problems.end());
    timed("graph", [&] { build_graph(system, landmarks, set); });
    return true;
  }

  template <class Ball>
  static BallPoint<Ball> enclose(const CertifiedPoint& point) {
    BallPoint<Ball> result;
    for (std::size_t j = 0; j < 4; ++j) {
      result[j] = Ball::enclosing(point.box()[j]);
    }
    return result;
  }

  template <class Ball>
  void trace_all(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks, const Rational& width,
                 TraceSet<Ball>& set) {
    trace_open_curves(system, landmarks, set);
    trace_closed_curves(system, landmarks, width, set);
    if (set.problems.empty()) {
      match_fibres(width, set);
      check_multiple_turning_values(set);
    }
  }

  /// +1, -1: the direction of the tangent field that enters the domain at this boundary point; 0: none;
  /// empty: unknown.
  template <class Ball>
  std::optional<int> entering_direction(const PairSystem<Ball>& system, const BallPoint<Ball>& box,
                                        const std::vector<Side>& sides) const {
    const BallPoint<Ball> tangent = Expansion<Ball>(system, box).tangent();
    int direction = 0;
    bool entering = true;
    for (const Side& side : sides) {
      const int sign = tangent[index(side.parameter)].certain_sign();
      if (sign == 0) {
        return std::nullopt;
      }
      const int inward = side.value == 0 ? sign : -sign;
      entering = entering && (direction == 0 || direction == inward);
      direction = inward;
    }
    return entering ? direction : 0;
  }

  template <class Ball>
  void trace_open_curves(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks,
                         TraceSet<Ball>& set) {
    std::vector<bool> used(landmarks.size(), false);
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
      if (used[i]) {
        continue;
      }
      used[i] = true;
      const auto direction = entering_direction(system, landmarks[i], boundary_[i].sides());
      if (!direction) {
        set.problems.push_back(
            {boundary_[i].box(),
             "the intersection curve is tangent to a side of a patch, or singular, at this boundary point"});
        continue;
      }
      if (*direction == 0) {
        set.isolated.push_back(static_cast<int>(i));
        continue;
      }
      auto outcome = trace_arc(system, landmarks, static_cast<int>(i), *direction, stop_);
      if (const auto* trace = std::get_if<Trace<Ball>>(&outcome)) {
        used[static_cast<std::size_t>(trace->end)] = true;
      }
      add_outcome(system, std::move(outcome), set);
    }
  }

  /// Fibre points that are on no curve traced so far start closed curves.
  template <class Ball>
  void trace_closed_curves(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks,
                           const Rational& width, TraceSet<Ball>& set) {
    for (const std::vector<CertifiedPoint>& fibre : fibres_) {
      for (const CertifiedPoint& point : fibre) {
        if (!set.problems.empty()) {
          return;
        }
        const BallPoint<Ball> box = enclose<Ball>(point.refined_to(width));
        if (curves_through(set, box) == 0) {
          add_outcome(system, trace_loop(system, landmarks, box, stop_), set);
        }
      }
    }
  }

  template <class Ball>
  static int curves_through(const TraceSet<Ball>& set, const BallPoint<Ball>& box) {
    return static_cast<int>(
        std::count_if(set.curves.begin(), set.curves.end(),
                      [&](const AnalysedTrace<Ball>& curve) { return passes_through(curve.trace, box); }));
  }

  template <class Ball>
  void add_outcome(const PairSystem<Ball>& system, std::variant<Trace<Ball>, TraceFailure> outcome,
                   TraceSet<Ball>& set) {
    if (const auto* failure = std::get_if<TraceFailure>(&outcome)) {
      set.problems.push_back({around(failure->where), failure->why});
      return;
    }
    AnalysedTrace<Ball> curve{std::get<Trace<Ball>>(std::move(outcome)), {}};
    auto turning = find_turning_points(system, curve.trace, coincident_);
    if (const auto* failure = std::get_if<TraceFailure>(&turning)) {
      set.problems.push_back({around(failure->where), failure->why});
      return;
    }
    curve.turning = std::get<std::vector<TurningPoint<Ball>>>(std::move(turning));
    result_.work.steps["tubes"] += static_cast<double>(curve.trace.pieces.size());
    set.curves.push_back(std::move(curve));
  }

  /// The values of the sweep parameter at the ends and turning points of a curve, in order; a closed curve's
  /// first turning point is repeated at the end.
  template <class Ball>
  std::vector<RationalInterval> monotone_stations(const AnalysedTrace<Ball>& curve) const {
    const std::size_t sweep = index(turning_->sweep);
    std::vector<RationalInterval> stations;
    const bool open = curve.trace.start >= 0;
    if (open) {
      stations.push_back(boundary_[static_cast<std::size_t>(curve.trace.start)].box()[sweep]);
    }
    for (const TurningPoint<Ball>& point : curve.turning) {
      if (std::count(point.parameters.begin(), point.parameters.end(), sweep) > 0) {
        stations.push_back(point.box[sweep].interval());
      }
    }
    if (open) {
      stations.push_back(boundary_[static_cast<std::size_t>(curve.trace.end)].box()[sweep]);
    } else if (!stations.empty()) {
      stations.push_back(stations.front());
    }
    return stations;
  }

  /// The bijection: between turning points a curve is monotone in the sweep parameter and so meets a sample
  /// between its ends exactly once; every fibre point lies on one curve; both numbers agree. A mismatch is an
  /// internal error.
  template <class Ball>
  void match_fibres(const Rational& width, TraceSet<Ball>& set) const {
    for (std::size_t k = 0; k < fibres_.size(); ++k) {
      std::size_t crossings = 0;
      for (const AnalysedTrace<Ball>& curve : set.curves) {
        const auto stations = monotone_stations(curve);
        for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
          const int a = side_of(stations[i], samples_[k]);
          const int b = side_of(stations[i + 1], samples_[k]);
          if (a == 0 || b == 0) {
            set.problems.push_back({whole_domain(), "a turning point cannot be separated from a sample"});
            return;
          }
          crossings += a != b ? 1 : 0;
        }
      }
      for (const CertifiedPoint& point : fibres_[k]) {
        if (curves_through(set, enclose<Ball>(point.refined_to(width))) != 1) {
          throw std::logic_error("internal error: a fibre point lies on no traced curve or on two");
        }
      }
      if (crossings != fibres_[k].size()) {
        throw std::logic_error("internal error: traced curves and exact fibre disagree at " +
                               std::string(name(turning_->sweep)) + " = " + samples_[k].str());
      }
    }
  }

  static int side_of(const RationalInterval& interval, const Rational& sample) {
    return interval.upper < sample ? -1 : interval.lower > sample ? 1 : 0;
  }

  /// Over a root of E of multiplicity m there is no singular point if m regular turning points lie over it:
  /// each of them takes up one of the m. (A simple root lies under no singular point: docs/method.md,
  /// section 4.)
  template <class Ball>
  void check_multiple_turning_values(TraceSet<Ball>& set) const {
    if (!turning_) {
      return;
    }
    const std::size_t sweep = index(turning_->sweep);
    for (const TurningValue& turning : turning_->values) {
      if (turning.multiplicity == 1) {
        continue;
      }
      const RationalInterval isolating = turning.value.interval();
      int regular = 0;
      for (const AnalysedTrace<Ball>& curve : set.curves) {
        for (const TurningPoint<Ball>& point : curve.turning) {
          const bool here = std::count(point.parameters.begin(), point.parameters.end(), sweep) > 0;
          regular += here && lies_over_only(turning, point.box[sweep].interval()) ? 1 : 0;
        }
      }
      if (regular != turning.multiplicity) {
        ParameterBox where = whole_domain();
        where[sweep] = isolating;
        set.problems.push_back({where,
                                "a multiple root of the turning eliminant: a singular or isolated point of "
                                "the intersection is not excluded here"});
      }
    }
  }

  /// True if `at`, which holds some turning value, can hold no other one than this.
  bool lies_over_only(const TurningValue& turning, const RationalInterval& at) const {
    return std::all_of(turning_->values.begin(), turning_->values.end(), [&](const TurningValue& other) {
      const RationalInterval interval = other.value.interval();
      const bool meets = at.lower <= interval.upper && at.upper >= interval.lower;
      return meets == (&other == &turning);
    });
  }

  template <class Ball>
  void build_graph(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks,
                   const TraceSet<Ball>& set) {
    IntersectionGraph& graph = result_.graph;
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
      Node node =
          boundary_node(system, scaling_.frame, landmarks[i], boundary_[i].box(), boundary_[i].sides());
      node.id = static_cast<int>(i);
      graph.nodes.push_back(std::move(node));
    }
    graph.isolated_points = set.isolated;
    const double tolerance = options_.tolerance * scaling_.extent;
    for (const AnalysedTrace<Ball>& curve : set.curves) {
      const std::size_t first = graph.arcs.size();
      append_trace(graph, curve, scaling_.frame, options_.turning, tolerance);
      for (std::size_t i = first; i < graph.arcs.size(); ++i) {
        if (!(graph.arcs[i].error_bound <= tolerance)) {
          incomplete(around(graph.arcs[i].polyline.front().parameters),
                     "the tolerance is below what polylines in doubles can be proved to keep here");
        }
        result_.work.steps["vertices"] += static_cast<double>(graph.arcs[i].polyline.size());
      }
    }
  }

  const BezierPatch& x_;
  const BezierPatch& y_;
  const IntersectOptions& options_;
  Clock::time_point start_ = Clock::now();
  Scaling scaling_;
  std::array<std::size_t, 4> coincident_;
  StopRequest stop_;
  std::vector<CertifiedPoint> boundary_;
  std::optional<TurningValues> turning_;
  std::vector<Rational> samples_;
  std::vector<std::vector<CertifiedPoint>> fibres_;
  IntersectResult result_{};
  double progress_ = 0;
};

}  // namespace

IntersectResult intersect(const BezierPatch& x, const BezierPatch& y, const IntersectOptions& options) {
  check(options);
  return Intersection(x, y, options).run();
}

}  // namespace exsect
