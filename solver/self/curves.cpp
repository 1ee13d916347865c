#include "self/curves.h"

#include <algorithm>

#include "answer/left_open.h"
#include "answer/parameter_box.h"
#include "self/directions.h"
#include "self/folds.h"
#include "self/glued_steps.h"
#include "self/loops.h"
#include "self/near_cusps.h"
#include "trace/enclose.h"
#include "trace/search_direction.h"

namespace exsect {

namespace {

constexpr long kQuickBoxes = 2000;

template <class Ball>
class SelfTracing {
 public:
  SelfTracing(const SelfSystem<Ball>& system, const Charts<DoubleBall>& charts, const ExactPlaces& exact,
              const Rational& width, SearchEffort effort, const StopRequest& stop)
      : system_(system),
        charts_(charts),
        exact_(exact),
        boundary_(exact.boundary),
        width_(width),
        effort_(effort),
        stop_(stop),
        places_(exact.injective.rectangles, boxes_of(exact.stars)),
        directions_(system, exact, result_) {
    for (const CertifiedPoint& point : boundary_.points) {
      result_.landmarks.push_back(enclose<Ball>(point, width));
    }
    if (!exact.folds.empty()) places_.further = FoldNeighbourhoods<Ball>(exact.folds);
    result_.boundary_points = boundary_.points.size();
    for (std::size_t k = 0; k < exact.stars.size(); ++k) {
      add_ports(k);
    }
  }

  SelfCurves<Ball> run() {
    add_near_cusps(result_, system_, exact_, places_, width_, stop_);
    directions_.start();
    for (const GluedArc& arc : boundary_.arcs) {
      if (result_.problems.empty()) {
        trace_glued(arc);
      }
    }
    if (result_.problems.empty()) {
      trace_open_curves();
    }
    if (result_.problems.empty()) {
      search_loops();
    }
    return std::move(result_);
  }

 private:
  static std::vector<ParameterBox> boxes_of(const std::vector<SelfStar>& stars) {
    std::vector<ParameterBox> boxes;
    boxes.reserve(stars.size());
    for (const SelfStar& star : stars) {
      boxes.push_back(star.surroundings);
    }
    return boxes;
  }

  void add_ports(std::size_t star) {
    const std::vector<Port>& ports = exact_.stars[star].star.ports;
    for (std::size_t i = 0; i < ports.size(); ++i) {
      const BallPoint<Ball> at = enclose<Ball>(ports[i].point, width_);
      result_.landmarks.push_back(at);
      result_.landmarks.push_back(exchanged_pair(at));
      result_.ports.push_back({star, i, false});
      result_.ports.push_back({star, i, true});
    }
  }

  void problem(const ParameterBox& where, const std::string& why) {
    result_.problems.push_back(left_open(where, why, stop_));
  }

  /// The arc is regular apart from the stars on it: its parts lead from one to the next and are all of it.
  void trace_glued(const GluedArc& arc) {
    const GluedSteps<Ball> steps(system_, exact_, result_, directions_);
    std::optional<GluedStep> step = steps.first(arc);
    for (std::size_t parts = 0; step && parts <= result_.ports.size(); ++parts) {
      auto outcome =
          trace_arc(system_.pair, result_.landmarks, static_cast<int>(step->landmark), step->sign, stop_);
      if (const auto* failure = std::get_if<TraceFailure>(&outcome)) {
        problem(around(failure->where), failure->why);
        return;
      }
      const auto* trace = std::get_if<Trace<Ball>>(&outcome);
      if (trace->end < 0) break;
      const int end = trace->end;
      directions_.use(step->landmark, step->sign);
      directions_.use(static_cast<std::size_t>(end), arriving_direction(*trace));
      add(std::move(outcome), arc.on);
      if (steps.is_last(arc, end)) return;
      step = steps.next(arc, end);
    }
    if (!result_.problems.empty()) return;
    problem(boundary_.points[arc.from].box(),
            "two parts of the boundary that meet from here on are tangent, or singular");
  }

  /// Ports first, so that as many curves as possible have the order of the star in which they end; gates
  /// next: at the boundary end of a folded line on a side it is not known which directions enter.
  void trace_open_curves() {
    const std::size_t boundary = boundary_.points.size();
    const std::size_t gates = boundary + result_.ports.size();
    for (std::size_t i = boundary; i < gates; i += 2) {
      start_at(is_exchanged(result_.port(static_cast<int>(i))->star) ? i + 1 : i);
    }
    for (std::size_t i = gates; i < result_.landmarks.size(); i += 2) {
      start_at(i);
    }
    std::vector<bool> seen(boundary, false);
    for (const SelfStar& star : exact_.stars) {
      if (star.landmark) {
        seen[*star.landmark] = seen[directions_.mate(*star.landmark)] = true;
      }
    }
    for (std::size_t i = boundary; i-- > 0;) {
      if (!seen[i]) {
        seen[i] = seen[directions_.mate(i)] = true;
        start_at(i);
      }
    }
  }

  /// A curve traced so far ends in the star in the other order than the star's own.
  bool is_exchanged(std::size_t star) const {
    return std::ranges::any_of(result_.curves, [&](const SelfCurve<Ball>& curve) {
      return std::ranges::any_of(std::array{curve.analysed.trace.start, curve.analysed.trace.end},
                                 [&](int end) {
                                   const auto* port = result_.port(end);
                                   return port != nullptr && port->star == star && port->exchanged;
                                 });
    });
  }

  void start_at(std::size_t i) {
    LeavingDirections directions = directions_.at(i);
    if (directions.signs.empty() && directions_.used(i).empty()) {
      result_.isolated.push_back(static_cast<int>(i));
    }
    for (const int used : directions_.used(i)) {
      std::erase(directions.signs, used);
    }
    if (!directions.signs.empty() && !directions.certain) {
      problem(directions_.is_boundary(i) ? boundary_.points[i].box()
                                         : around(approximation(result_.landmarks[i])),
              "the curve is tangent to a side of the patch, or singular, at this end point");
      return;
    }
    for (const int sign : directions.signs) {
      if (std::ranges::count(directions_.used(i), sign) > 0) {
        continue;  // the curve has come back
      }
      directions_.use(i, sign);
      auto outcome = trace_arc(system_.pair, result_.landmarks, static_cast<int>(i), sign, stop_);
      if (const auto* trace = std::get_if<Trace<Ball>>(&outcome)) {
        directions_.use(static_cast<std::size_t>(trace->end), arriving_direction(*trace));
      }
      add(std::move(outcome));
    }
  }

  static std::array<double, 4> approximation(const BallPoint<Ball>& p) {
    return {p[0].approximation(), p[1].approximation(), p[2].approximation(), p[3].approximation()};
  }

  void add(std::variant<Trace<Ball>, TraceFailure> outcome, const std::vector<Side>& on = {}) {
    if (const auto* failure = std::get_if<TraceFailure>(&outcome)) {
      problem(around(failure->where), failure->why);
      return;
    }
    SelfCurve<Ball> curve{{std::get<Trace<Ball>>(std::move(outcome)), {}}, on};
    std::array<bool, 4> constant = {};
    for (const Side& side : on) {
      constant[index(side.parameter)] = true;
    }
    mark_folded_line(curve, constant);
    const Trace<Ball>& trace = curve.analysed.trace;
    auto turning = find_turning_points(system_.pair, curve.analysed.trace, exact_.coincident,
                                       {constant,
                                        directions_.signs_at(trace.start),
                                        directions_.signs_at(trace.end),
                                        {},
                                        exact_.common_zero});
    if (const auto* failure = std::get_if<TraceFailure>(&turning)) {
      problem(around(failure->where), failure->why);
      return;
    }
    curve.analysed.turning = std::get<TurningPoints<Ball>>(std::move(turning));
    result_.curves.push_back(std::move(curve));
  }

  /// A curve that comes from the turn of a folded line, or from a port on it, runs along that line.
  void mark_folded_line(SelfCurve<Ball>& curve, std::array<bool, 4>& constant) const {
    for (const int end : {curve.analysed.trace.start, curve.analysed.trace.end}) {
      if (const auto* port = result_.port(end)) {
        if (const auto& folded = exact_.stars[port->star].folded[port->port])
          mark_folded_line(curve, constant, folded->fixed, folded->side);
        continue;
      }
      const auto gate = result_.gate(end);
      if (!gate) {
        continue;
      }
      const ChartTrace<Ball>& trace = result_.chart_traces[gate->trace];
      const CuspArc<Ball>& arc = result_.cusps[static_cast<std::size_t>(trace.start)];
      if (arc.place.folded)
        mark_folded_line(curve, constant, arc.chart == Chart::first ? 1 : 0, arc.place.side[1]);
    }
  }

  static void mark_folded_line(SelfCurve<Ball>& curve, std::array<bool, 4>& constant, std::size_t fixed,
                               const std::optional<int>& side) {
    constant[fixed] = constant[fixed + 2] = true;
    if (side) curve.on = {{static_cast<Parameter>(fixed), *side}, {static_cast<Parameter>(fixed + 2), *side}};
  }

  /// (U',V') on the pieces of the curves traced so far.
  std::vector<std::array<double, 2>> tangents() const {
    std::vector<std::array<double, 2>> result;
    for (const SelfCurve<Ball>& curve : result_.curves)
      for (const Piece<Ball>& piece : curve.analysed.trace.pieces)
        result.push_back(
            {piece.tube.slope[0] + piece.tube.slope[2], piece.tube.slope[1] + piece.tube.slope[3]});
    return result;
  }

  void search_loops() {
    const LoopHandler<Ball> handler = [this](std::variant<Trace<Ball>, TraceFailure> outcome) {
      const std::size_t before = result_.problems.size();
      add(std::move(outcome));
      return result_.problems.size() == before;
    };
    for (const ParameterBox& where :
         search_closed_curves(system_, charts_, exact_, places_, search_direction(tangents()), effort_,
                              result_, handler, stop_))
      problem(where, "a closed curve or a singular point of the self-intersection is not excluded here");
  }

  const SelfSystem<Ball>& system_;
  const Charts<DoubleBall>& charts_;
  const ExactPlaces& exact_;
  const SelfBoundary& boundary_;
  const Rational& width_;
  SearchEffort effort_;
  const StopRequest& stop_;
  KnownPlaces places_;
  SelfCurves<Ball> result_;
  SelfDirections<Ball> directions_;
};

}  // namespace

template <class Ball>
SelfCurves<Ball> trace_self_curves(const SelfSystem<Ball>& system, const Charts<DoubleBall>& charts,
                                   const ExactPlaces& exact, const Rational& width, SearchEffort effort,
                                   const StopRequest& stop) {
  return SelfTracing<Ball>(system, charts, exact, width, effort, stop).run();
}

bool is_quickly_injective(const SelfSystem<DoubleBall>& system, const StopRequest& stop) {
  return std::all_of(system.charts.begin(), system.charts.end(), [&](const ChartSystem<DoubleBall>& chart) {
    return search_chart<DoubleBall>(chart, KnownPlaces({}), {whole_chart}, {1, 0}, {}, kQuickBoxes, stop)
        .undecided.empty();
  });
}

#define EXSECT_INSTANTIATE_SELF_CURVES(Ball)                                                      \
  template SelfCurves<Ball> trace_self_curves(const SelfSystem<Ball>&, const Charts<DoubleBall>&, \
                                              const ExactPlaces&, const Rational&, SearchEffort,  \
                                              const StopRequest&);

EXSECT_INSTANTIATE_SELF_CURVES(DoubleBall)
EXSECT_INSTANTIATE_SELF_CURVES(ArbBall<256>)
#undef EXSECT_INSTANTIATE_SELF_CURVES

}  // namespace exsect
