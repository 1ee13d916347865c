#include "self/loops.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "answer/parameter_box.h"
#include "self/chart_directions.h"
#include "self/near_cusps.h"
#include "self/undecided_places.h"
#include "trace/loop_seeds.h"

namespace exsect {
namespace {

/// Of a brief search: what most searches need that succeed.
constexpr long kBriefBoxes = 5500;
/// So many boxes that doubles leave are taken up as they are in longer numbers, more are searched from the
/// start.
constexpr std::size_t kMostLeft = 2000;

template <class Ball, class SearchBall>
BallPoint<Ball> in_arithmetic(const BallPoint<SearchBall>& p) {
  if constexpr (std::is_same_v<Ball, SearchBall>) {
    return p;
  } else {
    BallPoint<Ball> result;
    for (std::size_t j = 0; j < 4; ++j) result[j] = Ball(p[j].approximation()).widened(p[j].radius());
    return result;
  }
}

template <class Ball>
class SelfLoops {
 public:
  SelfLoops(const SelfSystem<Ball>& system, const ExactPlaces& exact, const KnownPlaces& places,
            SearchEffort effort, SelfCurves<Ball>& found, const LoopHandler<Ball>& add,
            const StopRequest& stop)
      : system_(system),
        exact_(exact),
        places_(places),
        effort_(effort),
        found_(found),
        add_(add),
        stop_(stop) {}

  /// What is left of both charts by a search in the arithmetic of `charts`; `left`: what one before has left
  /// along c, in terms of u and v. A brief search looks along c alone.
  template <class SearchBall>
  BoxesByChart search(const Charts<SearchBall>& charts, const std::array<double, 2>& c,
                      const BoxesByChart& left) {
    const auto along = [&](Chart chart, const std::array<double, 2>& direction,
                           const std::vector<ChartBox>& roots) {
      return search_along(chart_of(charts, chart), direction, roots);
    };
    if (effort_ == SearchEffort::whole) return searched_along_one_direction(c, left, along, stop_);
    BoxesByChart undecided = {along(Chart::first, c, left[0]), along(Chart::second, c, left[1])};
    found_.is_cut_short = found_.is_cut_short || !is_decided(undecided);
    return undecided;
  }

 private:
  template <class SearchBall>
  std::vector<ChartBox> search_along(const ChartSystem<SearchBall>& chart,
                                     const std::array<double, 2>& direction,
                                     const std::vector<ChartBox>& roots) {
    const Chart which = chart.chart();
    const ChartSeedHandler<SearchBall> known = [this, which](const BallPoint<SearchBall>& p) {
      return is_known(which, in_arithmetic<Ball>(p));
    };
    SearchOutcome outcome =
        search_chart(chart, places_, roots, direction, known, most_boxes<SearchBall>(), stop_);
    found_.searched_boxes += outcome.boxes;
    return std::move(outcome.undecided);
  }

  template <class SearchBall>
  long most_boxes() const {
    return effort_ == SearchEffort::brief ? std::min(kBriefBoxes, kMostChartBoxes<SearchBall>)
                                          : kMostChartBoxes<SearchBall>;
  }

  bool is_known(Chart chart, const BallPoint<Ball>& p) {
    if (passes_near_cusp(found_, chart, p) || p[3].is_negative()) return true;
    if (!p[3].is_positive()) return false;
    const BallPoint<Ball> pair = pair_of(chart, p);
    const bool outside = std::ranges::any_of(
        pair, [](const Ball& c) { return c.is_negative() || (c - Ball(1)).is_positive(); });
    return outside || is_near_star(pair) || lies_on_curve(pair) || lies_on_curve(exchanged_pair(pair)) ||
           seeds_.trace(system_.pair, found_.landmarks, pair, stop_, add_);
  }

  bool is_near_star(const BallPoint<Ball>& pair) const {
    if (exact_.stars.empty()) return false;
    ParameterBox box;
    for (std::size_t j = 0; j < 4; ++j) box[j] = pair[j].interval();
    return std::ranges::any_of(exact_.stars, [&](const SelfStar& star) {
      return lies_in(box, star.surroundings) || lies_in(exchanged_pair(box), star.surroundings);
    });
  }

  bool lies_on_curve(const BallPoint<Ball>& pair) const {
    return std::ranges::any_of(found_.curves, [&](const SelfCurve<Ball>& curve) {
      return passes_through(curve.analysed.trace, pair);
    });
  }

  const SelfSystem<Ball>& system_;
  const ExactPlaces& exact_;
  const KnownPlaces& places_;
  SearchEffort effort_;
  SelfCurves<Ball>& found_;
  const LoopHandler<Ball>& add_;
  const StopRequest& stop_;
  LoopSeeds<Ball> seeds_;
};

}  // namespace

template <class Ball>
std::vector<ParameterBox> search_closed_curves(const SelfSystem<Ball>& system,
                                               const Charts<DoubleBall>& charts, const ExactPlaces& exact,
                                               const KnownPlaces& places,
                                               const std::array<double, 2>& direction, SearchEffort effort,
                                               SelfCurves<Ball>& found, const LoopHandler<Ball>& add,
                                               const StopRequest& stop) {
  SelfLoops<Ball> loops(system, exact, places, effort, found, add, stop);
  BoxesByChart left = loops.search(charts, direction, {{{whole_chart}, {whole_chart}}});
  if constexpr (!std::is_same_v<Ball, DoubleBall>) {
    if (!is_decided(left)) {
      for (std::vector<ChartBox>& boxes : left)
        if (boxes.size() > kMostLeft) boxes = {whole_chart};
      left = loops.search(system.charts, direction, left);
    }
  }
  std::vector<ParameterBox> undecided = undecided_places(Chart::first, left[0]);
  std::ranges::move(undecided_places(Chart::second, left[1]), std::back_inserter(undecided));
  return undecided;
}

#define EXSECT_INSTANTIATE_SELF_LOOPS(Ball)                                                       \
  template std::vector<ParameterBox> search_closed_curves(                                        \
      const SelfSystem<Ball>&, const Charts<DoubleBall>&, const ExactPlaces&, const KnownPlaces&, \
      const std::array<double, 2>&, SearchEffort, SelfCurves<Ball>&, const LoopHandler<Ball>&,    \
      const StopRequest&);

EXSECT_INSTANTIATE_SELF_LOOPS(DoubleBall)
EXSECT_INSTANTIATE_SELF_LOOPS(ArbBall<256>)
#undef EXSECT_INSTANTIATE_SELF_LOOPS

}  // namespace exsect
