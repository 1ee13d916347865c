#include "self_search.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace exsect {

namespace {

constexpr std::size_t kMostWaiting = 20000;
constexpr int kDeepest = 200;  // halvings, all variables together
constexpr int kFirstCertificateDepth = 6;
constexpr double kMostElongated = 0x1p8;

using Direction = std::array<double, 3>;

/// A box with the Bernstein coefficients of H on it.
template <class Ball>
struct ChartCell {
  ChartBox box;
  ChartNet<Ball, 2> net;
  int depth = 0;
};

constexpr std::size_t degree(std::size_t j) { return j == 3 ? 1 : 2; }

/// The Bernstein coefficients of the polynomial on a box.
template <class Ball>
ChartNet<Ball, 2> bernstein_net(ChartNet<Ball, 2> net, const ChartBox& box) {
  const auto stride = chart_strides(2);
  BallPoint<Ball> corner;
  for (std::size_t j = 0; j < 4; ++j) {
    corner[j] = Ball(box.lower[j]);
  }
  shift<Ball, 2>(net, corner);
  for (std::size_t j = 0; j < 4; ++j) {
    const Ball width = Ball(box.upper[j]) - Ball(box.lower[j]);
    for (std::size_t i = 0; i < net.size(); ++i) {
      if (exponent<2>(i, j) != 0) {
        continue;
      }
      for (std::size_t c = 0; c < 3; ++c) {
        const Ball b0 = net[i][c];
        Ball& b1 = net[i + stride[j]][c];
        const Ball linear = width * b1;
        if (degree(j) == 1) {
          b1 = b0 + linear;
        } else {
          Ball& b2 = net[i + 2 * stride[j]][c];
          b2 = b0 + linear + width * width * b2;
          b1 = b0 + Ball(0.5) * linear;
        }
      }
    }
  }
  return net;
}

/// de Casteljau at 1/2 in variable j; `net` becomes the left half, the right one is returned.
template <class Ball>
ChartNet<Ball, 2> halve(ChartNet<Ball, 2>& net, std::size_t j) {
  ChartNet<Ball, 2> right = net;
  const std::size_t stride = chart_strides(2)[j];
  const Ball half(0.5);
  for (std::size_t i = 0; i < net.size(); ++i) {
    if (exponent<2>(i, j) != 0) {
      continue;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      if (degree(j) == 1) {
        const Ball middle = half * (net[i][c] + net[i + stride][c]);
        net[i + stride][c] = middle;
        right[i][c] = middle;
        continue;
      }
      const Ball q0 = half * (net[i][c] + net[i + stride][c]);
      const Ball q1 = half * (net[i + stride][c] + net[i + 2 * stride][c]);
      const Ball middle = half * (q0 + q1);
      net[i + stride][c] = q0;
      net[i + 2 * stride][c] = middle;
      right[i][c] = middle;
      right[i + stride][c] = q1;
    }
  }
  return right;
}

/// True only if n . H has one certain sign on the whole box.
template <class Ball>
bool separated_along(const ChartNet<Ball, 2>& net, const Direction& n) {
  int sign = 0;
  for (const BallVector<Ball>& p : net) {
    const int s = (Ball(n[0]) * p[0] + Ball(n[1]) * p[1] + Ball(n[2]) * p[2]).certain_sign();
    if (s == 0 || s == -sign) {
      return false;
    }
    sign = s;
  }
  return true;
}

template <class Ball>
bool separated_on_axis(const ChartNet<Ball, 2>& net, std::size_t c) {
  const int sign = net[0][c].certain_sign();
  return sign != 0 && std::all_of(net.begin(), net.end(),
                                  [&](const BallVector<Ball>& p) { return p[c].certain_sign() == sign; });
}

/// Differences of the net in variable j between its ends, averaged: an estimate of the extent of H in it.
template <class Ball>
Direction mean_difference(const ChartNet<Ball, 2>& net, std::size_t j) {
  const std::size_t span = degree(j) * chart_strides(2)[j];
  Direction sum{};
  double count = 0;
  for (std::size_t i = 0; i < net.size(); ++i) {
    if (exponent<2>(i, j) != 0) {
      continue;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += net[i + span][c].approximation() - net[i][c].approximation();
    }
    ++count;
  }
  for (double& c : sum) {
    c /= count;
  }
  return sum;
}

template <class Ball>
bool cannot_vanish(const ChartNet<Ball, 2>& net) {
  for (std::size_t c = 0; c < 3; ++c) {
    if (separated_on_axis(net, c)) {
      return true;
    }
  }
  Direction mean{};
  for (const BallVector<Ball>& p : net) {
    for (std::size_t c = 0; c < 3; ++c) {
      mean[c] += p[c].approximation();
    }
  }
  if (separated_along(net, mean)) {
    return true;
  }
  // The image is nearly a zonotope: its faces are normal to the cross products of its generators.
  std::array<Direction, 4> generator;
  for (std::size_t j = 0; j < 4; ++j) {
    generator[j] = mean_difference(net, j);
  }
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t k = 0; k < j; ++k) {
      if (separated_along(net, cross<double>(generator[j], generator[k]))) {
        return true;
      }
    }
  }
  return false;
}

template <class Ball>
BallPoint<Ball> ball_box(const ChartBox& box) {
  BallPoint<Ball> result;
  for (std::size_t j = 0; j < 4; ++j) {
    const double half = 0.5 * (box.upper[j] - box.lower[j]);
    const double mid = 0.5 * (box.lower[j] + box.upper[j]);
    result[j] = Ball(mid).widened(half * (1 + 0x1p-40) + 0x1p-50 * std::fabs(mid));
  }
  return result;
}

/// No point of the box has both U +- t and V +- m t in [0,1]. Sums of two doubles and products of at most
/// three: the relative slack covers their rounding.
bool outside(const ChartBox& box) {
  const double w = box.lower[3] * (1 - 0x1p-40);
  const double least_m = box.lower[2] > 0 ? box.lower[2] : box.upper[2] < 0 ? -box.upper[2] : 0;
  const auto reach2 = [](double lower, double upper) {
    const double reach = std::max(0.0, std::min(upper, 1 - lower));
    return reach * reach * (1 + 0x1p-40);
  };
  return reach2(box.lower[0], box.upper[0]) < w ||
         reach2(box.lower[1], box.upper[1]) < least_m * least_m * w || box.upper[3] < 0;
}

/// The part of the box with w above its middle is outside.
bool is_half_outside(const ChartBox& box) {
  ChartBox upper = box;
  upper.lower[3] = 0.5 * (box.lower[3] + box.upper[3]);
  return upper.lower[3] > box.lower[3] && outside(upper);
}

double width_of(const ChartBox& box, std::size_t j) { return box.upper[j] - box.lower[j]; }

/// Halves w where one half is outside, else the variable in which H varies most, or one in which the box is
/// far longer; false if its midpoint is no double.
template <class Ball>
bool split(const ChartCell<Ball>& cell, std::array<ChartCell<Ball>, 2>& halves) {
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t j = 0; j < 4; ++j) {
    const std::size_t stride = chart_strides(2)[j];
    double extent = 0;
    for (std::size_t i = 0; i < cell.net.size(); ++i) {
      if (exponent<2>(i, j) == degree(j)) {
        continue;
      }
      for (std::size_t c = 0; c < 3; ++c) {
        extent = std::max(
            extent, std::fabs(cell.net[i + stride][c].approximation() - cell.net[i][c].approximation()));
      }
    }
    extent *= static_cast<double>(degree(j));
    if (extent > most && cell.box.upper[j] > cell.box.lower[j]) {
      most = extent;
      longest = j;
    }
  }
  // Along a curve of the box H does not vary.
  for (std::size_t j = 0; j < 4; ++j) {
    if (width_of(cell.box, j) > kMostElongated * width_of(cell.box, longest)) {
      longest = j;
    }
  }
  if (is_half_outside(cell.box)) {
    longest = 3;
  }
  const double middle = 0.5 * (cell.box.lower[longest] + cell.box.upper[longest]);
  if (middle - cell.box.lower[longest] != cell.box.upper[longest] - middle ||
      !(middle > cell.box.lower[longest])) {
    return false;
  }
  halves[0] = cell;
  halves[1].net = halve(halves[0].net, longest);
  halves[1].box = cell.box;
  halves[0].box.upper[longest] = middle;
  halves[1].box.lower[longest] = middle;
  halves[0].depth = halves[1].depth = cell.depth + 1;
  return true;
}

/// A tube that contains the whole box.
template <class Ball>
std::optional<ChartTube<Ball>> tube_around(const ChartSystem<Ball>& system, const ChartBox& box,
                                           std::optional<std::size_t> wanted_axis) {
  BallPoint<Ball> centre;
  std::array<double, 4> half{};
  for (std::size_t j = 0; j < 4; ++j) {
    centre[j] = Ball(0.5 * (box.lower[j] + box.upper[j]));
    half[j] = 0.5 * (box.upper[j] - box.lower[j]) * (1 + 0x1p-40);
  }
  const ChartNet<Ball, 2> taylor = system.taylor(centre);
  std::array<Direction, 4> column;
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

/// det(c_0 H_V - c_1 H_U, H_m, H_w / m) does not vanish on the box, and det(H_U, H_V, H_m) does not if the
/// box has points with m = 0: then no curve point in it is singular, or has c . (U',V') = 0 unless the curve
/// is the whole line U, V, m = 0 constant, which leaves the domain (method, section 7.3).
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
  std::array<BallVector<Ball>, 3> derivative;  // with respect to U, V, m
  for (std::size_t j = 0; j < 3; ++j) {
    const double width = cell.box.upper[j] - cell.box.lower[j];
    for (std::size_t k = 0; k < 3; ++k) {
      double lower = std::numeric_limits<double>::infinity();
      double upper = -lower;
      for (std::size_t i = 0; i < cell.net.size(); ++i) {
        if (exponent<2>(i, j) == 2) {
          continue;
        }
        const Ball difference = cell.net[i + stride[j]][k] - cell.net[i][k];
        const double mid = difference.approximation();
        const double radius = (difference - Ball(mid)).upper_magnitude();
        lower = std::min(lower, mid - radius);
        upper = std::max(upper, mid + radius);
      }
      const double mid = 0.5 * (lower + upper);
      const double radius = 0.5 * (upper - lower) + 0x1p-50 * (std::fabs(lower) + std::fabs(upper));
      derivative[j][k] = Ball(mid).widened(radius * (1 + 0x1p-40)) * Ball(2) * reciprocal(Ball(width));
    }
  }
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
ChartSearchOutcome subdivide(const ChartSystem<Ball>& system, const KnownPlaces& places, const ChartBox& root,
                             long most_boxes, const StopRequest& stop, const Done& done) {
  ChartSearchOutcome outcome;
  std::deque<ChartCell<Ball>> waiting;
  waiting.push_back({root, bernstein_net(system.equation(), root), 0});
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

KnownPlaces::KnownPlaces(const std::vector<ParameterRectangle>& rectangles,
                         const std::vector<ParameterBox>& boxes) {
  const auto add = [&](const ParameterBox& box) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Place place{};
    for (std::size_t j = 0; j < 4; ++j) {
      place.lower[j] = box[j].lower == 0 ? -kFar : to_double(box[j].lower);
      place.upper[j] = box[j].upper == 1 ? kFar : to_double(box[j].upper);
    }
    places_.push_back(place);
  };
  for (const auto& [u, v] : rectangles) add({u, v, u, v});
  for (const ParameterBox& box : boxes) {
    add(box);
    add({box[2], box[3], box[0], box[1]});
  }
}

SearchRegion pair_bounds(Chart chart, const ChartBox& box) {
  const double t0 = std::sqrt(std::max(0.0, box.lower[3])) * (1 - 0x1p-40);
  const double t1 = std::sqrt(std::max(0.0, box.upper[3])) * (1 + 0x1p-40);
  const auto products = {box.lower[2] * t0, box.lower[2] * t1, box.upper[2] * t0, box.upper[2] * t1};
  const double least = std::min(products);
  const double most = std::max(products);
  // U + t, V + m t, U - t, V - m t; a relative error of 2^-50 for each product and sum.
  SearchRegion pairs = {{box.lower[0] + t0, box.lower[1] + least, box.lower[0] - t1, box.lower[1] - most},
                        {box.upper[0] + t1, box.upper[1] + most, box.upper[0] - t0, box.upper[1] - least}};
  if (chart == Chart::second) {
    for (const std::size_t j : {0U, 2U}) {
      std::swap(pairs.lower[j], pairs.lower[j + 1]);
      std::swap(pairs.upper[j], pairs.upper[j + 1]);
    }
  }
  return pairs;
}

bool KnownPlaces::contain(Chart chart, const ChartBox& box) const {
  if (further && further(chart, box)) return true;
  if (places_.empty()) return false;
  const SearchRegion pairs = pair_bounds(chart, box);
  return std::ranges::any_of(places_, [&](const Place& place) {
    for (std::size_t j = 0; j < 4; ++j)
      if (!(pairs.lower[j] - 0x1p-48 >= place.lower[j] && pairs.upper[j] + 0x1p-48 <= place.upper[j]))
        return false;
    return true;
  });
}

template <class Ball>
ChartSearchOutcome search_chart(const ChartSystem<Ball>& system, const KnownPlaces& places,
                                const std::array<double, 2>& direction, const ChartSeedHandler<Ball>& known,
                                long most_boxes, const StopRequest& stop) {
  const auto done = [&](const ChartCell<Ball>& cell) {
    if (!known || cell.depth < kFirstCertificateDepth) {
      return false;
    }
    if (tangent_cannot_vanish(system, cell, direction)) {
      return true;
    }
    const auto tube = tube_around(system, cell.box, std::nullopt);
    if (!tube) {
      return false;
    }
    return known(point_at(*tube, 0)) || known(point_at(*tube, -tube->reach)) ||
           known(point_at(*tube, tube->reach));
  };
  return subdivide(system, places, whole_chart, most_boxes, stop, done);
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
  outcome.undecided = subdivide(system, places, root, kMostBoxes, stop, done).undecided;
  return outcome;
}

#define EXSECT_INSTANTIATE_SELF_SEARCH(Ball)                                                            \
  template ChartSearchOutcome search_chart(const ChartSystem<Ball>&, const KnownPlaces&,                \
                                           const std::array<double, 2>&, const ChartSeedHandler<Ball>&, \
                                           long, const StopRequest&);                                   \
  template CuspSearchOutcome<Ball> search_cusps(const ChartSystem<Ball>&, const KnownPlaces&,           \
                                                const StopRequest&);

EXSECT_INSTANTIATE_SELF_SEARCH(DoubleBall)
EXSECT_INSTANTIATE_SELF_SEARCH(ArbBall<256>)
#undef EXSECT_INSTANTIATE_SELF_SEARCH

}  // namespace exsect
