#include "self/tube.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "trace/preconditioned_newton.h"

namespace exsect {

namespace {

// Underflow loses less than 2^-1000, far below.
constexpr double kLeastHalfwidth = 0x1p-500;

template <class Ball>
std::optional<Matrix3> preconditioner(const ChartNet<Ball, 2>& taylor,
                                      const std::array<std::size_t, 3>& others) {
  std::array<Row3, 3> columns;
  for (std::size_t i = 0; i < 3; ++i) {
    const BallVector<Ball>& c = taylor[chart_strides(2)[others[i]]];
    columns[i] = {c[0].approximation(), c[1].approximation(), c[2].approximation()};
  }
  return approximate_inverse(columns);
}

/// Exponents of index i and the powers h^(exponents).
template <std::size_t W>
struct Monomial {
  explicit Monomial(std::size_t i)
      : power{exponent<W>(i, 0), exponent<W>(i, 1), exponent<W>(i, 2), exponent<W>(i, 3)},
        degree(power[0] + power[1] + power[2] + power[3]) {}
  std::array<std::size_t, 4> power;
  std::size_t degree;

  static double raised(double h, std::size_t n) { return n == 0 ? 1 : n == 1 ? h : h * h; }

  double at(const std::array<double, 4>& h) const {
    return raised(h[0], power[0]) * raised(h[1], power[1]) * raised(h[2], power[2]) * raised(h[3], power[3]);
  }
  /// The derivative with respect to variable j at h.
  double derivative(const std::array<double, 4>& h, std::size_t j) const {
    if (power[j] == 0) {
      return 0;
    }
    double value = static_cast<double>(power[j]) * raised(h[j], power[j] - 1);
    for (std::size_t i = 0; i < 4; ++i) {
      value *= i == j ? 1 : raised(h[i], power[i]);
    }
    return value;
  }
  /// The second derivative at h in the direction a.
  double second(const std::array<double, 4>& h, const std::array<double, 4>& a) const {
    double sum = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) {
        Monomial rest = *this;
        if (rest.power[j] == 0) {
          continue;
        }
        double factor = static_cast<double>(rest.power[j]--);
        if (rest.power[k] == 0) {
          continue;
        }
        factor *= static_cast<double>(rest.power[k]--);
        sum += factor * a[j] * a[k] * rest.at(h);
      }
    }
    return sum;
  }
};

template <class Ball>
Row3 magnitudes(const BallVector<Ball>& v) {
  return {v[0].upper_magnitude(), v[1].upper_magnitude(), v[2].upper_magnitude()};
}

/// |C H(p + tau d)| for |tau| <= reach.
template <class Ball>
Row3 residual_bounds(const ChartTube<Ball>& tube) {
  BallVector<Ball> linear;
  Row3 higher{};
  std::array<double, 4> d{};
  for (std::size_t j = 0; j < 4; ++j) {
    d[j] = std::fabs(tube.slope[j]) * tube.reach;
    for (std::size_t row = 0; row < 3; ++row) {
      linear[row] += tube.premultiplied[chart_strides(2)[j]][row] * Ball(tube.slope[j]);
    }
  }
  for (const std::size_t i : chart_support) {
    const Monomial<2> monomial(i);
    if (monomial.degree < 2) {
      continue;
    }
    const Row3 m = magnitudes(tube.premultiplied[i]);
    const double at = monomial.at(d);
    for (std::size_t row = 0; row < 3; ++row) {
      higher[row] += m[row] * at;
    }
  }
  Row3 result{};
  for (std::size_t row = 0; row < 3; ++row) {
    result[row] = kSlack * (tube.premultiplied[0][row].upper_magnitude() +
                            tube.reach * linear[row].upper_magnitude() + higher[row]);
  }
  return result;
}

/// Bounds of |C D_j(box) - ideal|, ideal = identity for j != axis and -d for j = axis: e[j][row].
template <class Ball>
std::array<Row3, 4> jacobian_deviation(const ChartTube<Ball>& tube, const std::array<std::size_t, 3>& others,
                                       const std::array<double, 4>& h) {
  std::array<Row3, 4> e{};
  for (const std::size_t i : chart_support) {
    const Monomial<2> monomial(i);
    if (monomial.degree < 2) {
      continue;
    }
    const Row3 m = magnitudes(tube.premultiplied[i]);
    for (std::size_t j = 0; j < 4; ++j) {
      const double derivative = monomial.derivative(h, j);
      for (std::size_t row = 0; row < 3; ++row) {
        e[j][row] += m[row] * derivative;
      }
    }
  }
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t row = 0; row < 3; ++row) {
      const Ball entry = tube.premultiplied[chart_strides(2)[j]][row];
      const double ideal = j == tube.axis ? -tube.slope[others[row]] : (others[row] == j ? 1.0 : 0.0);
      e[j][row] = kSlack * (e[j][row] + (entry - Ball(ideal)).upper_magnitude());
    }
  }
  return e;
}

/// C DH z' = 0 and C (DH z'' + D2H[z',z']) = 0 with C DH = 1 + E on the columns other than k.
template <class Ball>
void bound_derivatives(ChartTube<Ball>& tube, const std::array<std::size_t, 3>& others,
                       const std::array<double, 4>& h, const std::array<Row3, 4>& e) {
  const double amplification = tube.contraction / (1 - tube.contraction) * kSlack;
  Row3 first{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t j = 0; j < 4; ++j) {
      first[row] += e[j][row] * std::fabs(tube.slope[j]);
    }
  }
  const double steepest = *std::max_element(first.begin(), first.end());
  tube.slope_error = {};
  tube.second = {};
  tube.second_error = {};
  for (std::size_t row = 0; row < 3; ++row) {
    tube.slope_error[others[row]] = kSlack * (first[row] + amplification * steepest);
  }
  std::array<double, 4> a{};
  for (std::size_t j = 0; j < 4; ++j) {
    a[j] = std::fabs(tube.slope[j]) + tube.slope_error[j];
  }
  std::array<double, 4> magnitude{};
  for (std::size_t j = 0; j < 4; ++j) {
    magnitude[j] = std::fabs(tube.slope[j]);
  }
  BallVector<Ball> centre;
  Row3 deviation{};
  for (const std::size_t i : chart_support) {
    const Monomial<2> monomial(i);
    if (monomial.degree < 2) {
      continue;
    }
    // Terms of second order are taken at the centre and z' = d, everything else is deviation.
    const bool at_centre = monomial.degree == 2;
    const double form = at_centre ? monomial.second(h, tube.slope) : 0;
    const double bound =
        monomial.second(h, a) - (at_centre ? monomial.second(h, magnitude) : 0) * (1 - 0x1p-45);
    const Row3 m = magnitudes(tube.premultiplied[i]);
    for (std::size_t row = 0; row < 3; ++row) {
      centre[row] += tube.premultiplied[i][row] * Ball(form).widened(0x1p-50 * monomial.second(h, magnitude));
      deviation[row] += m[row] * bound;
    }
  }
  double largest = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    tube.second[others[row]] = -centre[row].approximation();
    deviation[row] += (centre[row] - Ball(centre[row].approximation())).upper_magnitude();
    largest = larger_bound(largest, std::fabs(tube.second[others[row]]) + deviation[row]);
  }
  for (std::size_t row = 0; row < 3; ++row) {
    tube.second_error[others[row]] = kSlack * (deviation[row] + amplification * largest);
  }
}

template <class Ball>
std::array<double, 4> half_widths(const ChartTube<Ball>& tube) {
  std::array<double, 4> h{};
  for (std::size_t j = 0; j < 4; ++j) {
    h[j] = kSlack * (std::fabs(tube.slope[j]) * tube.reach + (j == tube.axis ? 0 : tube.halfwidth));
  }
  return h;
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
  const auto others = other_axes(axis);
  const auto c = preconditioner(taylor, others);
  if (!c) {
    return std::nullopt;
  }
  for (const std::size_t i : chart_support) {
    tube.premultiplied[i] = preconditioned(*c, taylor[i]);
  }
  tube.slope[axis] = 1;
  for (std::size_t row = 0; row < 3; ++row) {
    tube.slope[others[row]] = -tube.premultiplied[chart_strides(2)[axis]][row].approximation();
  }
  const Row3 f = residual_bounds(tube);
  tube.halfwidth = std::max({2 * *std::max_element(f.begin(), f.end()), least_halfwidth, kLeastHalfwidth});
  const std::array<double, 4> h = half_widths(tube);
  const auto e = jacobian_deviation(tube, others, h);
  tube.contraction = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    const double sum = kSlack * (e[others[0]][row] + e[others[1]][row] + e[others[2]][row]);
    // Krawczyk: the image f + E Z lies strictly inside Z.
    if (!((f[row] + sum * tube.halfwidth) * kSlack < tube.halfwidth)) {
      return std::nullopt;
    }
    tube.contraction = larger_bound(tube.contraction, sum);
  }
  bound_derivatives(tube, others, h, e);
  return tube;
}

template <class Ball>
std::optional<BallPoint<Ball>> newton_corrected(const ChartSystem<Ball>& system, const BallPoint<Ball>& start,
                                                std::size_t axis, int steps) {
  const auto others = other_axes(axis);
  return newton_steps<Ball>(start, axis, steps, [&](const BallPoint<Ball>& p) {
    const ChartNet<Ball, 2> taylor = system.taylor(p);
    const auto c = preconditioner(taylor, others);
    return c ? std::optional(preconditioned(*c, taylor[0])) : std::nullopt;
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
  const Ball tau = offset(tube, box);
  if (!(tau.upper_magnitude() <= tube.reach)) {
    return false;
  }
  for (const std::size_t j : other_axes(tube.axis)) {
    const Ball e = box[j] - tube.centre[j] - tau * Ball(tube.slope[j]);
    if (!(e.upper_magnitude() <= tube.halfwidth)) {
      return false;
    }
  }
  return true;
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
  for (std::size_t i = 0; i < net.size(); ++i) {
    const Monomial<3> monomial(i);
    double term = monomial.second(h, a);
    for (std::size_t j = 0; j < 4; ++j) {
      term += monomial.derivative(h, j) * (std::fabs(tube.second[j]) + tube.second_error[j]);
    }
    const Row3 m = magnitudes(net[i]);
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
