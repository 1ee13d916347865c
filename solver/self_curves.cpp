#include "self_curves.h"

#include <algorithm>
#include <cmath>

#include "landmark_tangent.h"
#include "loop_seeds.h"
#include "parameter_box.h"
#include "self_folds.h"
#include "self_near_cusps.h"
#include "traced_curves.h"
#include "undecided_places.h"

namespace exsect {

namespace {

constexpr long kQuickBoxes = 2000;

template <class Ball>
class SelfTracing {
 public:
  SelfTracing(const SelfSystem<Ball>& system, const ExactPlaces& exact, const Rational& width,
              const StopRequest& stop)
      : system_(system),
        exact_(exact),
        boundary_(exact.boundary),
        width_(width),
        stop_(stop),
        places_(exact.injective.rectangles, boxes_of(exact.stars)) {
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
    used_.assign(result_.landmarks.size(), {});
    for (const MultipleFold& fold : exact_.folds) {
      use_ends(fold);
    }
    for (const GluedArc& arc : boundary_.arcs) {
      if (result_.problems.empty()) {
        trace_glued(arc);
      }
    }
    if (result_.problems.empty()) {
      trace_open_curves();
    }
    if (result_.problems.empty()) {
      search_closed_curves();
    }
    return std::move(result_);
  }

 private:
  static std::vector<ParameterBox> boxes_of(const std::vector<SelfStar>& stars) {
    std::vector<ParameterBox> boxes;
    for (const SelfStar& star : stars) {
      boxes.push_back(star.star.box);
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
    result_.problems.push_back({where, stop_ && stop_() ? "the work cap was reached" : why});
  }

  /// The directions of the tangent field that may enter the domain at a boundary point; `certain`: they do.
  struct Directions {
    std::vector<int> signs = {1, -1};
    bool certain = true;
  };

  Directions entering_directions(std::size_t landmark) const {
    const BallPoint<Ball> tangent = Expansion<Ball>(system_.pair, result_.landmarks[landmark]).tangent();
    Directions result;
    for (const Side& side : boundary_.points[landmark].sides()) {
      const int sign = tangent[index(side.parameter)].certain_sign();
      if (sign != 0) {
        std::erase(result.signs, side.value == 0 ? -sign : sign);
        continue;
      }
      const std::size_t j = index(side.parameter);
      const int bend = bend_sign(system_.pair, result_.landmarks[landmark], j);
      if (bend == 0 || signs_at(static_cast<int>(landmark))[j] != 0) {
        result.certain = false;
      } else if ((bend > 0) != (side.value == 0)) {
        result.signs.clear();
      }
    }
    return result;
  }

  /// The direction of the tangent field in which the trace in the charts goes on at its gate; 0: unknown.
  int leaving_direction(const ChartTrace<Ball>& trace) const {
    const BallPoint<Ball> tangent = Expansion<Ball>(system_.pair, trace.gate).tangent();
    for (std::size_t j = 0; j < 4; ++j) {
      const int sign = trace.direction[j] * tangent[j].certain_sign();
      if (sign != 0) {
        return sign;
      }
    }
    return 0;
  }

  std::size_t mate(std::size_t landmark) const {
    const std::size_t n = boundary_.points.size();
    return landmark < n ? boundary_.mate[landmark] : n + ((landmark - n) ^ 1U);
  }

  bool is_boundary(std::size_t landmark) const { return landmark < boundary_.points.size(); }
  const ChartTrace<Ball>& trace_at(std::size_t gate) const {
    return result_.chart_traces[result_.gate(static_cast<int>(gate))->trace];
  }

  /// Nothing else leaves the pair on a side, or a port, in which an arc of the line ends.
  void use_ends(const MultipleFold& fold) {
    const auto use_both = [this](std::size_t landmark) {
      for (const int sign : {1, -1}) use(landmark, sign);
    };
    if (fold.end) use_both(*fold.end);
    for (std::size_t i = 0; i < result_.ports.size(); ++i) {
      const auto& port = result_.ports[i];
      if (lies_on(fold, exact_.stars[port.star], port.port)) use_both(result_.boundary_points + i);
    }
  }

  /// The arc is regular and leads from one of its ends to the other one: then it is all of the curve.
  void trace_glued(const GluedArc& arc) {
    const BallPoint<Ball> tangent = Expansion<Ball>(system_.pair, result_.landmarks[arc.from]).tangent();
    const int sign = tangent[index(arc.along)].certain_sign();
    std::variant<Trace<Ball>, TraceFailure> outcome = TraceFailure{};
    if (sign != 0) {
      outcome = trace_arc(system_.pair, result_.landmarks, static_cast<int>(arc.from), sign, stop_);
    }
    const auto* trace = std::get_if<Trace<Ball>>(&outcome);
    if (!trace || trace->end != static_cast<int>(arc.to)) {
      problem(boundary_.points[arc.from].box(),
              "two parts of the boundary that meet from here on are tangent, or singular");
      return;
    }
    use(arc.from, sign);
    use(arc.to, arriving_direction(*trace));
    add(std::move(outcome), arc.on);
  }

  /// Ports first, so that as many curves as possible have the order of the star in which they end; gates
  /// next: at the boundary end of a folded line on a side it is not known which directions enter.
  void trace_open_curves() {
    const std::size_t boundary = boundary_.points.size();
    const std::size_t gates = boundary + result_.ports.size();
    for (std::size_t i = boundary; i < gates; i += 2) {
      start_at(i);
    }
    for (std::size_t i = gates; i < used_.size(); i += 2) {
      start_at(i);
    }
    std::vector<bool> seen(boundary, false);
    for (const SelfStar& star : exact_.stars) {
      if (star.landmark) {
        seen[*star.landmark] = seen[mate(*star.landmark)] = true;
      }
    }
    for (std::size_t i = boundary; i-- > 0;) {
      if (!seen[i]) {
        seen[i] = seen[mate(i)] = true;
        start_at(i);
      }
    }
  }

  /// Away from the centre of the star.
  Directions outward(std::size_t landmark) const {
    const auto& [star, number, exchanged] = *result_.port(static_cast<int>(landmark));
    const Port& port = exact_.stars[star].star.ports[number];
    const BallPoint<Ball> tangent = Expansion<Ball>(system_.pair, result_.landmarks[landmark]).tangent();
    const int sign = tangent[(index(port.across) + (exchanged ? 2 : 0)) % 4].certain_sign();
    return sign == 0 ? Directions{{1, -1}, false} : Directions{{sign * port.side}, true};
  }

  Directions directions_at(std::size_t i) const {
    if (is_boundary(i)) {
      return entering_directions(i);
    }
    if (result_.port(static_cast<int>(i)) != nullptr) {
      return outward(i);
    }
    const int direction = leaving_direction(trace_at(i));
    return direction == 0 ? Directions{{1, -1}, false} : Directions{{direction}, true};
  }

  void start_at(std::size_t i) {
    Directions directions = directions_at(i);
    if (directions.signs.empty() && used_[i].empty()) {
      result_.isolated.push_back(static_cast<int>(i));
    }
    for (const int used : used_[i]) {
      std::erase(directions.signs, used);
    }
    if (!directions.signs.empty() && !directions.certain) {
      problem(is_boundary(i) ? boundary_.points[i].box() : around(approximation(result_.landmarks[i])),
              "the curve is tangent to a side of the patch, or singular, at this end point");
      return;
    }
    for (const int sign : directions.signs) {
      if (std::ranges::count(used_[i], sign) > 0) {
        continue;  // the curve has come back
      }
      use(i, sign);
      auto outcome = trace_arc(system_.pair, result_.landmarks, static_cast<int>(i), sign, stop_);
      if (const auto* trace = std::get_if<Trace<Ball>>(&outcome)) {
        use(static_cast<std::size_t>(trace->end), arriving_direction(*trace));
      }
      add(std::move(outcome));
    }
  }

  /// A curve leaves the landmark in this direction, and the exchanged one the exchanged landmark: there T is
  /// the opposite.
  void use(std::size_t landmark, int sign) {
    used_[landmark].push_back(sign);
    used_[mate(landmark)].push_back(-sign);
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
                                       {constant, signs_at(trace.start), signs_at(trace.end), {}});
    if (const auto* failure = std::get_if<TraceFailure>(&turning)) {
      problem(around(failure->where), failure->why);
      return;
    }
    curve.analysed.turning = std::get<std::vector<TurningPoint<Ball>>>(std::move(turning));
    result_.curves.push_back(std::move(curve));
  }

  /// T at a landmark; nothing for -1.
  TangentSigns signs_at(int landmark) const {
    if (landmark < 0) {
      return {};
    }
    const auto i = static_cast<std::size_t>(landmark);
    return tangent_signs(system_.pair, result_.landmarks[i], [&] {
      return is_boundary(i) ? exact_.zero_tangent(boundary_.points[i]) : std::array<bool, 4>{};
    });
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

  /// The direction c for which c . (U',V') keeps clearest away from zero on the curves traced so far: any c
  /// is legal, a good one leaves fewer boxes.
  std::array<double, 2> search_direction() const {
    std::array<double, 2> best = {1, 0.375};
    double best_value = -1;
    for (int i = 0; i < 16; ++i) {
      const std::array<double, 2> c = {std::cos(0.19 * i), std::sin(0.19 * i)};
      double least = 1;
      for (const SelfCurve<Ball>& curve : result_.curves) {
        for (const Piece<Ball>& piece : curve.analysed.trace.pieces) {
          const double du = piece.tube.slope[0] + piece.tube.slope[2];
          const double dv = piece.tube.slope[1] + piece.tube.slope[3];
          least = std::min(least, std::fabs(c[0] * du + c[1] * dv) / std::max(1e-300, std::hypot(du, dv)));
        }
      }
      if (least > best_value) {
        best_value = least;
        best = c;
      }
    }
    return best;
  }

  void search_closed_curves() {
    const std::array<double, 2> c = search_direction();
    for (const ChartSystem<Ball>& chart : system_.charts) {
      const Chart which = chart.chart();
      const ChartSeedHandler<Ball> known = [this, which](const BallPoint<Ball>& p) {
        return is_known(which, p);
      };
      const std::array<double, 2> own = which == Chart::first ? c : std::array<double, 2>{c[1], c[0]};
      const ChartSearchOutcome outcome =
          search_chart(chart, places_, own, known, kMostChartBoxes<Ball>, stop_);
      result_.searched_boxes += outcome.boxes;
      for (const ParameterBox& where : undecided_places(which, outcome.undecided)) {
        problem(where, "a closed curve or a singular point of the self-intersection is not excluded here");
      }
    }
  }

  bool is_known(Chart chart, const BallPoint<Ball>& p) {
    if (passes_near_cusp(result_, chart, p) || p[3].is_negative()) {
      return true;
    }
    if (!p[3].is_positive()) {
      return false;
    }
    const BallPoint<Ball> pair = pair_of(chart, p);
    for (const Ball& c : pair) {
      if (c.is_negative() || (c - Ball(1)).is_positive()) {
        return true;
      }
    }
    return is_in_star(pair) || lies_on_curve(pair) || lies_on_curve(exchanged_pair(pair)) ||
           seeds_.trace(system_.pair, result_.landmarks, pair, stop_, [this](auto outcome) {
             const std::size_t before = result_.problems.size();
             add(std::move(outcome));
             return result_.problems.size() == before;
           });
  }

  bool is_in_star(const BallPoint<Ball>& pair) const {
    ParameterBox box;
    for (std::size_t j = 0; j < 4; ++j) {
      box[j] = pair[j].interval();
    }
    return std::any_of(exact_.stars.begin(), exact_.stars.end(), [&](const SelfStar& star) {
      return lies_in(box, star.star.box) || lies_in(exchanged_pair(box), star.star.box);
    });
  }

  bool lies_on_curve(const BallPoint<Ball>& pair) const {
    return std::any_of(result_.curves.begin(), result_.curves.end(), [&](const SelfCurve<Ball>& curve) {
      return passes_through(curve.analysed.trace, pair);
    });
  }

  const SelfSystem<Ball>& system_;
  const ExactPlaces& exact_;
  const SelfBoundary& boundary_;
  const Rational& width_;
  const StopRequest& stop_;
  KnownPlaces places_;
  std::vector<std::vector<int>> used_;  // directions of T in which a curve leaves each landmark
  LoopSeeds<Ball> seeds_;
  SelfCurves<Ball> result_;
};

}  // namespace

template <class Ball>
SelfCurves<Ball> trace_self_curves(const SelfSystem<Ball>& system, const ExactPlaces& exact,
                                   const Rational& width, const StopRequest& stop) {
  return SelfTracing<Ball>(system, exact, width, stop).run();
}

bool is_quickly_injective(const SelfSystem<DoubleBall>& system, const StopRequest& stop) {
  return std::all_of(system.charts.begin(), system.charts.end(), [&](const ChartSystem<DoubleBall>& chart) {
    return search_chart<DoubleBall>(chart, KnownPlaces({}), {1, 0}, {}, kQuickBoxes, stop).undecided.empty();
  });
}

#define EXSECT_INSTANTIATE_SELF_CURVES(Ball)                                                                \
  template SelfCurves<Ball> trace_self_curves(const SelfSystem<Ball>&, const ExactPlaces&, const Rational&, \
                                              const StopRequest&);

EXSECT_INSTANTIATE_SELF_CURVES(DoubleBall)
EXSECT_INSTANTIATE_SELF_CURVES(ArbBall<256>)
#undef EXSECT_INSTANTIATE_SELF_CURVES

}  // namespace exsect
