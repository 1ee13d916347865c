#include "self/search.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "self/chart_cell.h"
#include "trace/tube_points.h"

namespace exsect {

namespace {

constexpr std::size_t kMostWaiting = 20000;
constexpr int kDeepest = 200;  // halvings, all variables together
constexpr int kFirstCertificateDepth = 6;

using Column = std::array<double, 3>;

template <class Ball>
BallPoint<Ball> ball_box(const ChartBox& box) {
  BallPoint<Ball> result;
  for (std::size_t j = 0; j < 4; ++j) {
    const double half = 0.5 * (box.upper[j] - box.lower[j]);
    const double mid = 0.5 * (box.lower[j] + box.upper[j]);
    result[j] = Ball(mid).widened(half * kSlack + 0x1p-50 * std::fabs(mid));
  }
  return result;
}

/// A tube that contains the whole box.
template <class Ball>
std::optional<ChartTube<Ball>> tube_around(const ChartSystem<Ball>& system, const ChartBox& box,
                                           std::optional<std::size_t> wanted_axis) {
  BallPoint<Ball> centre;
  std::array<double, 4> half{};
  for (std::size_t j = 0; j < 4; ++j) {
    centre[j] = Ball(0.5 * (box.lower[j] + box.upper[j]));
    half[j] = 0.5 * (box.upper[j] - box.lower[j]) * kSlack;
  }
  const ChartNet<Ball, 2> taylor = system.taylor(centre);
  std::array<Column, 4> column;
  for (std::size_t j = 0; j < 4; ++j) {
    const BallVector<Ball>& c = taylor[chart_strides(2)[j]];
    column[j] = {c[0].approximation(), c[1].approximation(), c[2].approximation()};
  }
  const std::array<double, 4> tangent = {dot<double>(column[1], cross<double>(column[2], column[3])),
                                         -dot<double>(column[0], cross<double>(column[2], column[3])),
                                         dot<double>(column[0], cross<double>(column[1], column[3])),
                                         -dot<double>(column[0], cross<double>(column[1], column[2]))};
  std::size_t axis = 0;
  for (std::size_t j = 1; j < 4; ++j) {
    axis = std::fabs(tangent[j]) > std::fabs(tangent[axis]) ? j : axis;
  }
  axis = wanted_axis.value_or(axis);
  const auto start = newton_corrected(system, centre, axis, 3);
  if (!start) {
    return std::nullopt;
  }
  double needed = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    const double slope = tangent[j] / tangent[axis];
    if (j != axis) {
      needed = std::max(needed, ((*start)[j] - centre[j]).upper_magnitude() + half[j] +
                                    1.01 * std::fabs(slope) * half[axis]);
    }
  }
  const double reach = std::max(half[axis] * 1.01, 0x1p-30 * needed);
  auto tube = certify_chart_tube(system, *start, axis, reach, needed * 1.01);
  if (!tube || !contains(*tube, ball_box<Ball>(box))) {
    return std::nullopt;
  }
  return tube;
}

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

/// Breadth first: what is left when the budget ends are small boxes around the difficult places.
template <class Ball, class Done>
ChartSearchOutcome subdivide(const ChartSystem<Ball>& system, const KnownPlaces& places,
                             const std::vector<ChartBox>& roots, long most_boxes, const StopRequest& stop,
                             const Done& done) {
  ChartSearchOutcome outcome;
  std::deque<ChartCell<Ball>> waiting;
  for (const ChartBox& root : roots) {
    waiting.push_back(chart_cell(system, root));
    if (roots.size() > 1) waiting.back().depth = kFirstCertificateDepth;  // left by a search that reached it
  }
  std::array<ChartCell<Ball>, 2> halves;
  while (!waiting.empty()) {
    const ChartCell<Ball> cell = std::move(waiting.front());
    waiting.pop_front();
    ++outcome.boxes;
    if (outside(cell.box) || places.contain(system.chart(), cell.box) || cannot_vanish(cell.net) ||
        done(cell)) {
      continue;
    }
    const bool stopped = outcome.boxes > most_boxes || waiting.size() > kMostWaiting ||
                         (stop && outcome.boxes % 64 == 0 && stop());
    if (stopped || cell.depth >= kDeepest || !split(cell, halves)) {
      outcome.undecided.push_back(cell.box);
      if (stopped) {
        for (const ChartCell<Ball>& other : waiting) {
          outcome.undecided.push_back(other.box);
        }
        break;
      }
      continue;
    }
    waiting.push_back(std::move(halves[0]));
    waiting.push_back(std::move(halves[1]));
  }
  return outcome;
}

}  // namespace

template <class Ball>
ChartSearchOutcome search_chart(const ChartSystem<Ball>& system, const KnownPlaces& places,
                                const std::vector<ChartBox>& roots, const std::array<double, 2>& direction,
                                const ChartSeedHandler<Ball>& known, long most_boxes,
                                const StopRequest& stop) {
  const bool is_first = system.chart() == Chart::first;
  const std::array<double, 2> own = is_first ? direction : std::array<double, 2>{direction[1], direction[0]};
  const auto done = [&](const ChartCell<Ball>& cell) {
    if (!known || cell.depth < kFirstCertificateDepth) {
      return false;
    }
    if (tangent_cannot_vanish(system, cell, own)) {
      return true;
    }
    const auto tube = tube_around(system, cell.box, std::nullopt);
    if (!tube) {
      return false;
    }
    return known(point_at(*tube, 0)) || known(point_at(*tube, -tube->reach)) ||
           known(point_at(*tube, tube->reach));
  };
  return subdivide(system, places, roots, most_boxes, stop, done);
}

template <class Ball>
CuspSearchOutcome<Ball> search_cusps(const ChartSystem<Ball>& system, const KnownPlaces& places,
                                     const StopRequest& stop) {
  constexpr long kMostBoxes = 20000;
  constexpr std::size_t kAxisW = 3;
  CuspSearchOutcome<Ball> outcome;
  const auto done = [&](const ChartCell<Ball>& cell) {
    if (cell.depth < kFirstCertificateDepth) {
      return false;
    }
    const auto tube = tube_around(system, cell.box, kAxisW);
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
  outcome.undecided = subdivide(system, places, {root}, kMostBoxes, stop, done).undecided;
  return outcome;
}

#define EXSECT_INSTANTIATE_SELF_SEARCH(Ball)                                                           \
  template ChartSearchOutcome search_chart(const ChartSystem<Ball>&, const KnownPlaces&,               \
                                           const std::vector<ChartBox>&, const std::array<double, 2>&, \
                                           const ChartSeedHandler<Ball>&, long, const StopRequest&);   \
  template CuspSearchOutcome<Ball> search_cusps(const ChartSystem<Ball>&, const KnownPlaces&,          \
                                                const StopRequest&);

EXSECT_INSTANTIATE_SELF_SEARCH(DoubleBall)
EXSECT_INSTANTIATE_SELF_SEARCH(ArbBall<256>)
#undef EXSECT_INSTANTIATE_SELF_SEARCH

}  // namespace exsect
