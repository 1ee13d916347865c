#include "self/chart_cell.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace exsect {

namespace {

constexpr double kMostElongated = 0x1p8;

using Direction = std::array<double, 3>;

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

/// The part of the box with w above its middle is outside.
bool is_half_outside(const ChartBox& box) {
  ChartBox upper = box;
  upper.lower[3] = 0.5 * (box.lower[3] + box.upper[3]);
  return upper.lower[3] > box.lower[3] && outside(upper);
}

double width_of(const ChartBox& box, std::size_t j) { return box.upper[j] - box.lower[j]; }

}  // namespace

template <class Ball>
ChartCell<Ball> chart_cell(const ChartSystem<Ball>& system, const ChartBox& box) {
  return {box, bernstein_net(system.equation(), box), 0};
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
BallVector<Ball> derivative_over(const ChartCell<Ball>& cell, std::size_t j) {
  const auto stride = chart_strides(2);
  const double width = width_of(cell.box, j);
  BallVector<Ball> result;
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
    result[k] = Ball(mid).widened(radius * kSlack) * Ball(2) * reciprocal(Ball(width));
  }
  return result;
}

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

#define EXSECT_INSTANTIATE_CHART_CELL(Ball)                                       \
  template ChartCell<Ball> chart_cell(const ChartSystem<Ball>&, const ChartBox&); \
  template bool cannot_vanish(const ChartNet<Ball, 2>&);                          \
  template BallVector<Ball> derivative_over(const ChartCell<Ball>&, std::size_t); \
  template bool split(const ChartCell<Ball>&, std::array<ChartCell<Ball>, 2>&);

EXSECT_INSTANTIATE_CHART_CELL(DoubleBall)
EXSECT_INSTANTIATE_CHART_CELL(ArbBall<256>)
#undef EXSECT_INSTANTIATE_CHART_CELL

}  // namespace exsect
