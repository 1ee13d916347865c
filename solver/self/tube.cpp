#include "self/tube.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

namespace exsect {

namespace {

// Underflow loses less than 2^-1000, far below.
constexpr double kLeastHalfwidth = 0x1p-500;

template <std::size_t W>
TermExponents exponents_of(std::size_t i) {
  return {exponent<W>(i, 0), exponent<W>(i, 1), exponent<W>(i, 2), exponent<W>(i, 3)};
}

/// Those of H (straight_tube.h).
template <class Ball>
struct ChartEquations {
  using Number = Ball;
  const ChartNet<Ball, 2>& net;

  template <class F>
  void for_each_term(const F& f) const {
    for (const std::size_t i : chart_support) f(exponents_of<2>(i), net[i]);
  }
};

template <class Ball>
std::array<BallVector<Ball>, 4> derivatives(const ChartNet<Ball, 2>& taylor) {
  const auto stride = chart_strides(2);
  return {taylor[stride[0]], taylor[stride[1]], taylor[stride[2]], taylor[stride[3]]};
}

/// The value of a Taylor net at an offset.
template <class Ball, std::size_t W>
BallVector<Ball> value_at(const ChartNet<Ball, W>& net, const BallPoint<Ball>& o) {
  const auto horner = [&o](std::size_t j, std::size_t degree, const auto& coefficient) {
    BallVector<Ball> sum = coefficient(degree);
    for (std::size_t n = degree; n-- > 0;) {
      const BallVector<Ball> lower = coefficient(n);
      for (std::size_t c = 0; c < 3; ++c) {
        sum[c] = lower[c] + o[j] * sum[c];
      }
    }
    return sum;
  };
  const auto stride = chart_strides(W);
  return horner(0, 2, [&](std::size_t i) {
    return horner(1, 2, [&](std::size_t j) {
      return horner(2, 2, [&](std::size_t k) {
        return horner(3, W - 1,
                      [&](std::size_t l) { return net[i * stride[0] + j * stride[1] + k * stride[2] + l]; });
      });
    });
  });
}

}  // namespace

template <class Ball>
std::optional<ChartTube<Ball>> certify_tube(const ChartSystem<Ball>& system, const BallPoint<Ball>& centre,
                                            std::size_t axis, double reach, double least_halfwidth) {
  ChartTube<Ball> tube;
  tube.axis = axis;
  tube.reach = reach;
  for (std::size_t j = 0; j < 4; ++j) {
    tube.centre[j] = centre[j].midpoint();
  }
  const ChartNet<Ball, 2> taylor = system.taylor(tube.centre);
  const auto line = linearised(derivatives(taylor), axis);
  if (!line) {
    return std::nullopt;
  }
  tube.slope = line->slope;
  for (const std::size_t i : chart_support) {
    tube.premultiplied[i] = preconditioned(line->preconditioner, taylor[i]);
  }
  const ChartEquations<Ball> g{tube.premultiplied};
  const Row3 f = residual_on_line(g, axis, tube.slope, reach);
  tube.halfwidth = std::max({2 * *std::max_element(f.begin(), f.end()), least_halfwidth, kLeastHalfwidth});
  const std::array<double, 4> h = half_widths(tube);
  const JacobianDeviation e = jacobian_deviation(g, axis, tube.slope, h);
  const Row3 sums = row_sums(e, axis);
  for (std::size_t row = 0; row < 3; ++row) {
    if (!((f[row] + sums[row] * tube.halfwidth) * kSlack < tube.halfwidth)) {  // (5.3)
      return std::nullopt;
    }
  }
  tube.contraction = largest_of(sums);
  tube.slope_error = slope_errors(e, axis, tube.slope, tube.contraction);
  const SecondDerivative second =
      second_derivative(g, axis, tube.slope, tube.slope_error, h, e, tube.contraction);
  tube.second = second.middle;
  tube.second_error = second.error;
  return tube;
}

template <class Ball>
std::optional<BallPoint<Ball>> newton_corrected(const ChartSystem<Ball>& system, const BallPoint<Ball>& start,
                                                std::size_t axis, int steps) {
  return newton_steps<Ball>(start, axis, steps, [&](const BallPoint<Ball>& p) {
    const ChartNet<Ball, 2> taylor = system.taylor(p);
    const auto line = linearised(derivatives(taylor), axis);
    return line ? std::optional(preconditioned(line->preconditioner, taylor[0])) : std::nullopt;
  });
}

template <class Ball>
BallPoint<Ball> point_at(const ChartTube<Ball>& tube, double tau) {
  const auto others = other_axes(tube.axis);
  BallPoint<Ball> o;
  for (std::size_t j = 0; j < 4; ++j) {
    o[j] = j == tube.axis ? Ball(tau) : (Ball(tau) * Ball(tube.slope[j])).midpoint();
  }
  // |z - z*| <= |C H(z)| / (1 - rho) for any z in the region; iterate z - C H(z) while that shrinks.
  auto [best_offset, residual] = contracted<Ball>(
      o, tube.axis, [&](const BallPoint<Ball>& at) { return value_at<Ball, 2>(tube.premultiplied, at); });
  double radius = kSlack * *std::max_element(residual.begin(), residual.end()) / (1 - tube.contraction);
  bool inside = true;
  for (const std::size_t j : others) {
    const Ball from_line = best_offset[j] - Ball(tau) * Ball(tube.slope[j]);
    inside = inside && from_line.upper_magnitude() <= tube.halfwidth;
  }
  if (!inside) {  // the bound holds in the region only; the region itself is an enclosure
    for (const std::size_t j : others) {
      best_offset[j] = Ball(tau) * Ball(tube.slope[j]);
    }
    radius = tube.halfwidth;
  }
  BallPoint<Ball> result;
  for (std::size_t j = 0; j < 4; ++j) {
    result[j] = tube.centre[j] + (j == tube.axis ? Ball(tau) : best_offset[j].widened(radius));
  }
  return result;
}

template <class Ball>
bool contains(const ChartTube<Ball>& tube, const BallPoint<Ball>& box) {
  return contains_within(tube, box, tube.halfwidth);
}

template <class Ball>
double space_second_derivative(const ChartSystem<Ball>& system, const ChartTube<Ball>& tube) {
  ChartNet<Ball, 3> net = system.space();
  shift<Ball, 3>(net, tube.centre);
  const std::array<double, 4> h = half_widths(tube);
  std::array<double, 4> a{};
  for (std::size_t j = 0; j < 4; ++j) {
    a[j] = std::fabs(tube.slope[j]) + tube.slope_error[j];
  }
  Row3 sum{};
  const MonomialsAt monomials(h);
  for (std::size_t i = 0; i < net.size(); ++i) {
    const Row3 m = straight::magnitudes(net[i]);
    if (m == Row3{}) continue;
    const TermExponents e = exponents_of<3>(i);
    double term = monomials.second(e, a);
    for (std::size_t j = 0; j < 4; ++j) {
      term += monomials.derivative(e, j) * (std::fabs(tube.second[j]) + tube.second_error[j]);
    }
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += m[c] * term;
    }
  }
  return kSlack * length_bound(sum[0], sum[1], sum[2]);
}

template <class Ball>
BallVector<Ball> space_point(const ChartSystem<Ball>& system, const BallPoint<Ball>& p) {
  return value_at<Ball, 3>(system.space(), p);
}

#define EXSECT_INSTANTIATE_CHART_TUBE(Ball)                                                                  \
  template std::optional<ChartTube<Ball>> certify_tube(const ChartSystem<Ball>&, const BallPoint<Ball>&,     \
                                                       std::size_t, double, double);                         \
  template std::optional<BallPoint<Ball>> newton_corrected(const ChartSystem<Ball>&, const BallPoint<Ball>&, \
                                                           std::size_t, int);                                \
  template BallPoint<Ball> point_at(const ChartTube<Ball>&, double);                                         \
  template bool contains(const ChartTube<Ball>&, const BallPoint<Ball>&);                                    \
  template double space_second_derivative(const ChartSystem<Ball>&, const ChartTube<Ball>&);                 \
  template BallVector<Ball> space_point(const ChartSystem<Ball>&, const BallPoint<Ball>&);

EXSECT_INSTANTIATE_CHART_TUBE(DoubleBall)
EXSECT_INSTANTIATE_CHART_TUBE(ArbBall<256>)
#undef EXSECT_INSTANTIATE_CHART_TUBE

}  // namespace exsect
