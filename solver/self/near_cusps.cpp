#include "self/near_cusps.h"

#include <algorithm>

#include "answer/left_open.h"
#include "answer/parameter_box.h"
#include "self/chart_turning.h"
#include "self/undecided_places.h"

namespace exsect {
namespace {

template <class Ball>
class NearCusps {
 public:
  NearCusps(SelfCurves<Ball>& result, const SelfSystem<Ball>& system, const ExactPlaces& exact,
            const KnownPlaces& places, const Rational& width, const StopRequest& stop)
      : result_(result), system_(system), exact_(exact), places_(places), width_(width), stop_(stop) {}

  void run() {
    find_cusps();
    if (result_.problems.empty()) {
      trace_from_cusps();
    }
  }

 private:
  void problem(const ParameterBox& where, const std::string& why) {
    result_.problems.push_back(left_open(where, why, stop_));
  }

  void find_cusps() {
    for (const ChartSystem<Ball>& chart : system_.charts) {
      const CuspSearchOutcome<Ball> outcome = search_cusps(chart, places_, stop_);
      for (const ParameterBox& where : undecided_places(chart.chart(), outcome.undecided)) {
        problem(where, "cuspidal points are not isolated here: a cuspidal curve, or a degenerate one");
      }
      for (const ChartCusp<Ball>& cusp : outcome.cusps) {
        add_cusp(chart, cusp);
      }
    }
  }

  void add_cusp(const ChartSystem<Ball>& chart, const ChartCusp<Ball>& cusp) {
    for (std::size_t j = 0; j < 2; ++j) {
      if (cusp.at[j].is_negative() || (cusp.at[j] - Ball(1)).is_positive()) {
        return;
      }
    }
    if (is_in_star(chart.chart(), cusp.at) || passes_near_cusp(result_, chart.chart(), cusp.at)) {
      return;  // |m| = 1 belongs to both charts
    }
    const auto arc = cusp_arc(chart, cusp, exact_place(chart, cusp, exact_.cusps, width_));
    if (!arc) {
      add_problem(
          chart.chart(), cusp.at,
          "a cuspidal point that is nearly singular, or nearly on a side or on a folded parameter line");
    } else if (arc->leaves()) {
      result_.leaving.push_back(*arc);
    } else {
      result_.cusps.push_back(*arc);
    }
  }

  /// Of which it is the centre then. Boxes of the search may all be larger than such a star.
  bool is_in_star(Chart chart, const BallPoint<Ball>& cusp) const {
    const std::size_t own = chart == Chart::first ? 0 : 1;
    const RationalInterval u = cusp[own].interval(), v = cusp[1 - own].interval();
    return std::ranges::any_of(exact_.stars, [&](const SelfStar& star) {
      return star.cuspidal && lies_in({u, v, u, v}, star.star.box);
    });
  }

  void add_problem(Chart chart, const BallPoint<Ball>& cusp, const char* why) {
    std::array<double, 2> at = {cusp[0].approximation(), cusp[1].approximation()};
    if (chart == Chart::second) {
      std::swap(at[0], at[1]);
    }
    problem(around({at[0], at[1], at[0], at[1]}), why);
  }

  /// A curve that joins two cuspidal points may be found from one of them, and end at a gate from the other
  /// one.
  void trace_from_cusps() {
    std::vector<bool> joined(result_.cusps.size(), false);
    std::vector<ChartTrace<Ball>> traces;
    for (std::size_t k = 0; k < result_.cusps.size(); ++k) {
      if (joined[k]) {
        continue;
      }
      traces.push_back(trace_from_cusp(system_.charts, result_.cusps, static_cast<int>(k), stop_));
      if (traces.back().end >= 0) {
        joined[k] = joined[static_cast<std::size_t>(traces.back().end)] = true;
      }
    }
    for (ChartTrace<Ball>& trace : traces) {
      if (trace.end < 0 && joined[static_cast<std::size_t>(trace.start)]) {
        continue;
      }
      if (const auto failure = find_chart_turning_points(system_.charts, trace, exact_.coincident, stop_)) {
        problem(around(failure->where), failure->why);
        return;
      }
      if (trace.end < 0) {
        result_.gates.push_back(result_.chart_traces.size());
        result_.landmarks.push_back(trace.gate);
        result_.landmarks.push_back(exchanged_pair(trace.gate));
      }
      result_.chart_traces.push_back(std::move(trace));
    }
  }

  SelfCurves<Ball>& result_;
  const SelfSystem<Ball>& system_;
  const ExactPlaces& exact_;
  const KnownPlaces& places_;
  const Rational& width_;
  const StopRequest& stop_;
};

}  // namespace

template <class Ball>
void add_near_cusps(SelfCurves<Ball>& found, const SelfSystem<Ball>& system, const ExactPlaces& exact,
                    const KnownPlaces& places, const Rational& width, const StopRequest& stop) {
  NearCusps<Ball>(found, system, exact, places, width, stop).run();
}

template <class Ball>
bool passes_near_cusp(const SelfCurves<Ball>& curves, Chart chart, const BallPoint<Ball>& point) {
  const auto passes = [&](const CuspArc<Ball>& arc) { return passes_through(arc, chart, point); };
  return std::any_of(curves.cusps.begin(), curves.cusps.end(), passes) ||
         std::any_of(curves.leaving.begin(), curves.leaving.end(), passes) ||
         std::any_of(curves.chart_traces.begin(), curves.chart_traces.end(),
                     [&](const ChartTrace<Ball>& trace) { return passes_through(trace, chart, point); });
}

#define EXSECT_INSTANTIATE_NEAR_CUSPS(Ball)                                                    \
  template void add_near_cusps(SelfCurves<Ball>&, const SelfSystem<Ball>&, const ExactPlaces&, \
                               const KnownPlaces&, const Rational&, const StopRequest&);       \
  template bool passes_near_cusp(const SelfCurves<Ball>&, Chart, const BallPoint<Ball>&);

EXSECT_INSTANTIATE_NEAR_CUSPS(DoubleBall)
EXSECT_INSTANTIATE_NEAR_CUSPS(ArbBall<256>)
#undef EXSECT_INSTANTIATE_NEAR_CUSPS

}  // namespace exsect
