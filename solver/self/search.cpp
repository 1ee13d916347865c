#include "self/search.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include "self/chart_cell.h"
#include "self/pair_rates.h"
#include "trace/covering_tube.h"

namespace exsect {

namespace {

constexpr std::size_t kMostWaiting = 20000;
constexpr int kDeepest = 200;  // halvings, all variables together
constexpr int kFirstCertificateDepth = 6;
constexpr double kAnywhere = std::numeric_limits<double>::infinity();

/// (7.8) det(c_0 H_V - c_1 H_U, H_m, H_w / m) does not vanish on the box, and det(H_U, H_V, H_m) does not if
/// the box has points with m = 0: then no curve point in it is singular, or has c . (U',V') = 0 unless the
/// curve is the whole line U, V, m = 0 constant, which leaves the domain (method, section 7.3).
template <class Ball>
bool tangent_cannot_vanish(const ChartSystem<Ball>& system, const ChartCell<Ball>& cell,
                           const std::array<double, 2>& c) {
  const BallPoint<Ball> box = ball_box<Ball>(cell.box);
  const ChartNet<Ball, 2>& power = system.equation();
  const auto stride = chart_strides(2);
  // H_w / m = c21 + 2 c22 V + m (c12 + 2 c22 U), read off the coefficients of m w and m^2 w.
  BallVector<Ball> quotient;
  for (std::size_t k = 0; k < 3; ++k) {
    quotient[k] = power[stride[2] + 1][k] + box[1] * power[stride[1] + stride[2] + 1][k] +
                  box[2] * (power[2 * stride[2] + 1][k] + box[0] * power[stride[0] + 2 * stride[2] + 1][k]);
  }
  const std::array<BallVector<Ball>, 3> derivative = {derivative_over(cell, 0), derivative_over(cell, 1),
                                                      derivative_over(cell, 2)};
  BallVector<Ball> mixed;
  for (std::size_t k = 0; k < 3; ++k) {
    mixed[k] = Ball(c[0]) * derivative[1][k] - Ball(c[1]) * derivative[0][k];
  }
  if (dot(mixed, cross(derivative[2], quotient)).certain_sign() == 0) {
    return false;
  }
  return cell.box.lower[2] > 0 || cell.box.upper[2] < 0 ||
         dot(derivative[0], cross(derivative[1], derivative[2])).certain_sign() != 0;
}

/// The boxes in which H may vanish, outside the known places, until `is_found` holds (breadth_first.h).
template <class Ball, class IsFound>
class ChartCover {
 public:
  using Cell = ChartCell<Ball>;

  ChartCover(const ChartSystem<Ball>& system, const KnownPlaces& places, const IsFound& is_found)
      : system_(system), places_(places), is_found_(is_found) {}

  SearchOutcome run(const std::vector<ChartBox>& roots, long most_boxes, const StopRequest& stop) {
    std::deque<Cell> waiting;
    for (const ChartBox& root : roots) {
      waiting.push_back(chart_cell(system_, root));
      if (roots.size() > 1)
        waiting.back().depth = kFirstCertificateDepth;  // left by a search that reached it
    }
    return search_breadth_first(*this, std::move(waiting), {most_boxes, kMostWaiting}, stop);
  }

  bool is_done(const Cell& cell) const {
    return outside(cell.box) || places_.contain(system_.chart(), cell.box) || cannot_vanish(cell.net) ||
           (cell.depth >= kFirstCertificateDepth && is_found_(cell));
  }
  static bool split(const Cell& cell, std::deque<Cell>& waiting) {
    std::array<Cell, 2> halves;
    if (cell.depth >= kDeepest || !exsect::split(cell, halves)) return false;
    for (Cell& half : halves) waiting.push_back(std::move(half));
    return true;
  }
  static const ChartBox& region_of(const Cell& cell) { return cell.box; }

 private:
  const ChartSystem<Ball>& system_;
  const KnownPlaces& places_;
  const IsFound& is_found_;
};

}  // namespace

template <class Ball>
SearchOutcome search_chart(const ChartSystem<Ball>& system, const KnownPlaces& places,
                           const std::vector<ChartBox>& roots, const std::array<double, 2>& direction,
                           const ChartSeedHandler<Ball>& known, long most_boxes, const StopRequest& stop) {
  const bool is_first = system.chart() == Chart::first;
  const std::array<double, 2> own = is_first ? direction : std::array<double, 2>{direction[1], direction[0]};
  const auto is_found = [&](const ChartCell<Ball>& cell) {
    if (!known) return false;
    if (tangent_cannot_vanish(system, cell, own)) return true;
    const auto tube = covering_tube(system, cell.box, std::nullopt, kAnywhere);
    return tube && is_arc_known(*tube, known);
  };
  return ChartCover(system, places, is_found).run(roots, most_boxes, stop);
}

template <class Ball>
CuspSearchOutcome<Ball> search_cusps(const ChartSystem<Ball>& system, const KnownPlaces& places,
                                     const StopRequest& stop) {
  constexpr long kMostBoxes = 20000;
  constexpr std::size_t kAxisW = 3;
  CuspSearchOutcome<Ball> outcome;
  const auto is_found = [&](const ChartCell<Ball>& cell) {
    const auto tube = covering_tube(system, cell.box, kAxisW, kAnywhere);
    if (!tube) {
      return false;
    }
    const ChartCusp<Ball> cusp = {*tube, point_at(*tube, -tube->centre[kAxisW].approximation())};
    const bool found_before =
        std::any_of(outcome.cusps.begin(), outcome.cusps.end(), [&](const ChartCusp<Ball>& other) {
          return contains(other.tube, cusp.at) || contains(cusp.tube, other.at);
        });
    if (!found_before) {
      outcome.cusps.push_back(cusp);
    }
    return true;
  };
  ChartBox root = whole_chart;
  root.upper[kAxisW] = 0;
  outcome.undecided = ChartCover(system, places, is_found).run({root}, kMostBoxes, stop).undecided;
  return outcome;
}

#define EXSECT_INSTANTIATE_SELF_SEARCH(Ball)                                                      \
  template SearchOutcome search_chart(const ChartSystem<Ball>&, const KnownPlaces&,               \
                                      const std::vector<ChartBox>&, const std::array<double, 2>&, \
                                      const ChartSeedHandler<Ball>&, long, const StopRequest&);   \
  template CuspSearchOutcome<Ball> search_cusps(const ChartSystem<Ball>&, const KnownPlaces&,     \
                                                const StopRequest&);

EXSECT_INSTANTIATE_SELF_SEARCH(DoubleBall)
EXSECT_INSTANTIATE_SELF_SEARCH(ArbBall<256>)
#undef EXSECT_INSTANTIATE_SELF_SEARCH

}  // namespace exsect
