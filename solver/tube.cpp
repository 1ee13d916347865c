#include "tube.h"

#include <algorithm>
#include <cmath>

#include "preconditioned_newton.h"

namespace exsect {

namespace {

// Factor that covers rounding in sums of nonnegative terms: fewer than 128 terms, each a product of at most
// six factors, lose less than (1 - 2^-53)^140 > 1 - 2^-45; underflow loses less than 2^-1000, far below every
// half width accepted (2^-500).
constexpr double kSlack = 1 + 0x1p-40;
constexpr double kLeastHalfwidth = 0x1p-500;

using Row = Row3;

/// Taylor index of the first derivative that column j of the Jacobian is made of.
constexpr std::size_t column_index(std::size_t j) { return j % 2 == 0 ? 3 : 1; }

template <class Ball>
std::optional<Matrix3> preconditioner(const Expansion<Ball>& at, const std::array<std::size_t, 3>& others) {
  std::array<Row, 3> columns;
  for (std::size_t i = 0; i < 3; ++i) {
    const BallVector<Ball> c = at.column(others[i]);
    columns[i] = {c[0].approximation(), c[1].approximation(), c[2].approximation()};
  }
  return approximate_inverse(columns);
}

/// Magnitudes of one Taylor net's coefficient rows: m[index][row].
using Magnitudes = std::array<Row, 9>;

template <class Ball>
Magnitudes magnitudes(const TaylorNet<Ball>& net) {
  Magnitudes m{};
  for (std::size_t i = 0; i < 9; ++i) {
    m[i] = {net[i][0].upper_magnitude(), net[i][1].upper_magnitude(), net[i][2].upper_magnitude()};
  }
  return m;
}

/// Bounds of the variation of the two first derivatives of a biquadratic net over |a| <= ha, |b| <= hb.
struct Variation {
  double first;
  double second;
};
Variation variation(const Magnitudes& m, std::size_t row, double ha, double hb) {
  return {2 * m[6][row] * ha + m[4][row] * hb + 2 * m[7][row] * ha * hb + m[5][row] * hb * hb +
              2 * m[8][row] * ha * hb * hb,
          2 * m[2][row] * hb + m[4][row] * ha + 2 * m[5][row] * ha * hb + m[7][row] * ha * ha +
              2 * m[8][row] * ha * ha * hb};
}

/// One row of the quadratic form of second derivatives at w' = d (signed, at the centre) is twice this.
template <class Ball>
Ball quadratic_term(const TaylorNet<Ball>& g, std::size_t row, double da, double db) {
  return g[6][row] * Ball(da * da).widened(0x1p-52 * da * da) +
         g[4][row] * Ball(da * db).widened(0x1p-52 * std::fabs(da * db)) +
         g[2][row] * Ball(db * db).widened(0x1p-52 * db * db);
}

/// Bound of the deviation of the quadratic form D2(box)[w', w'] from its value at the centre with w' = d, one
/// patch.
double quadratic_deviation(const Magnitudes& m, std::size_t row, const double* d, const double* delta,
                           const double* h) {
  const double a0 = std::fabs(d[0]) + delta[0];
  const double a1 = std::fabs(d[1]) + delta[1];
  const double at_centre = 2 * m[6][row] * delta[0] * (a0 + std::fabs(d[0])) +
                           2 * m[4][row] * (delta[0] * std::fabs(d[1]) + a0 * delta[1]) +
                           2 * m[2][row] * delta[1] * (a1 + std::fabs(d[1]));
  const double higher = 2 * (m[7][row] * h[1] + m[8][row] * h[1] * h[1]) * a0 * a0 +
                        4 * (m[7][row] * h[0] + m[5][row] * h[1] + 2 * m[8][row] * h[0] * h[1]) * a0 * a1 +
                        2 * (m[5][row] * h[0] + m[8][row] * h[0] * h[0]) * a1 * a1;
  return at_centre + higher;
}

/// |C F(p + tau d)| for |tau| <= reach: F is a quartic in tau along the line.
template <class Ball>
double residual_bound(const Tube<Ball>& tube, std::size_t row) {
  const auto& d = tube.slope;
  Ball constant = tube.premultiplied[0][0][row] + tube.premultiplied[1][0][row];
  Ball linear;
  double quadratic = 0;
  Ball second;
  double cubic = 0;
  double quartic = 0;
  for (std::size_t p = 0; p < 2; ++p) {
    const TaylorNet<Ball>& g = tube.premultiplied[p];
    const double da = d[2 * p];
    const double db = d[2 * p + 1];
    linear += g[3][row] * Ball(da) + g[1][row] * Ball(db);
    second += quadratic_term(g, row, da, db);
    cubic += std::fabs(da * da * db) * g[7][row].upper_magnitude() +
             std::fabs(da * db * db) * g[5][row].upper_magnitude();
    quartic += da * da * db * db * g[8][row].upper_magnitude();
  }
  quadratic = second.upper_magnitude();
  const double t = tube.reach;
  return kSlack * (constant.upper_magnitude() +
                   t * (linear.upper_magnitude() + t * (quadratic + t * (cubic + t * quartic))));
}

/// Row sums of |C D_j(box) - ideal|, ideal = identity for j != axis and -d for j = axis.
template <class Ball>
std::array<Row, 4> jacobian_deviation(const Tube<Ball>& tube, const std::array<Magnitudes, 2>& m,
                                      const std::array<std::size_t, 3>& others,
                                      const std::array<double, 4>& h) {
  std::array<Row, 4> e{};
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t row = 0; row < 3; ++row) {
      const Ball entry = tube.premultiplied[j / 2][column_index(j)][row];
      const double ideal = j == tube.axis ? -tube.slope[others[row]] : (others[row] == j ? 1.0 : 0.0);
      const Variation v = variation(m[j / 2], row, h[j / 2 * 2], h[j / 2 * 2 + 1]);
      e[j][row] = kSlack * ((entry - Ball(ideal)).upper_magnitude() + (j % 2 == 0 ? v.first : v.second));
    }
  }
  return e;
}

template <class Ball>
void bound_derivatives(Tube<Ball>& tube, const std::array<Magnitudes, 2>& m,
                       const std::array<std::size_t, 3>& others, const std::array<double, 4>& h,
                       const std::array<Row, 4>& e) {
  const double amplification = tube.contraction / (1 - tube.contraction) * kSlack;
  Row g{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t j = 0; j < 4; ++j) {
      g[row] += e[j][row] * std::fabs(tube.slope[j]);
    }
  }
  const double largest = *std::max_element(g.begin(), g.end());
  tube.slope_error = {};
  for (std::size_t row = 0; row < 3; ++row) {
    tube.slope_error[others[row]] = kSlack * (g[row] + amplification * largest);
  }
  Row deviation{};
  double largest_second = 0;
  tube.second = {};
  tube.second_error = {};
  for (std::size_t row = 0; row < 3; ++row) {
    Ball form;
    for (std::size_t p = 0; p < 2; ++p) {
      form += quadratic_term(tube.premultiplied[p], row, tube.slope[2 * p], tube.slope[2 * p + 1]);
      deviation[row] +=
          quadratic_deviation(m[p], row, &tube.slope[2 * p], &tube.slope_error[2 * p], &h[2 * p]);
    }
    const double centre = form.approximation();
    deviation[row] += 2 * (form - Ball(centre)).upper_magnitude();
    tube.second[others[row]] = -2 * centre;
    largest_second = std::max(largest_second, std::fabs(2 * centre) + deviation[row]);
  }
  for (std::size_t row = 0; row < 3; ++row) {
    tube.second_error[others[row]] = kSlack * (deviation[row] + amplification * largest_second);
  }
}

/// X'' = x_u u'' + x_v v'' + x_uu u'^2 + 2 x_uv u'v' + x_vv v'^2, bounded term by term.
template <class Ball>
double bound_space_second_derivative(const Tube<Ball>& tube, const std::array<double, 4>& h) {
  const Magnitudes m = magnitudes(tube.space);
  const double a0 = std::fabs(tube.slope[0]) + tube.slope_error[0];
  const double a1 = std::fabs(tube.slope[1]) + tube.slope_error[1];
  const double u2 = std::fabs(tube.second[0]) + tube.second_error[0];
  const double v2 = std::fabs(tube.second[1]) + tube.second_error[1];
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const Variation v = variation(m, c, h[0], h[1]);
    const double xuu = 2 * (m[6][c] + m[7][c] * h[1] + m[8][c] * h[1] * h[1]);
    const double xuv = m[4][c] + 2 * m[7][c] * h[0] + 2 * m[5][c] * h[1] + 4 * m[8][c] * h[0] * h[1];
    const double xvv = 2 * (m[2][c] + m[5][c] * h[0] + m[8][c] * h[0] * h[0]);
    const double bound = (m[3][c] + v.first) * u2 + (m[1][c] + v.second) * v2 + xuu * a0 * a0 +
                         2 * xuv * a0 * a1 + xvv * a1 * a1;
    sum += bound * bound;
  }
  return kSlack * std::sqrt(sum);
}

}  // namespace

template <class Ball>
std::optional<Tube<Ball>> certify_tube(const PairSystem<Ball>& system, const BallPoint<Ball>& centre,
                                       std::size_t axis, double reach, double least_halfwidth) {
  Tube<Ball> tube;
  tube.axis = axis;
  tube.reach = reach;
  for (std::size_t j = 0; j < 4; ++j) {
    tube.centre[j] = centre[j].midpoint();
  }
  const Expansion<Ball> at(system, tube.centre);
  const auto others = other_axes(axis);
  const auto c = preconditioner(at, others);
  tube.orientation = at.tangent()[axis].certain_sign();
  if (!c || tube.orientation == 0) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < 9; ++i) {
    tube.premultiplied[0][i] = preconditioned(*c, at.x[i]);
    tube.premultiplied[1][i] = preconditioned(*c, BallVector<Ball>{-at.y[i][0], -at.y[i][1], -at.y[i][2]});
  }
  tube.space = at.x;
  tube.slope[axis] = 1;
  for (std::size_t row = 0; row < 3; ++row) {
    tube.slope[others[row]] = -tube.premultiplied[axis / 2][column_index(axis)][row].approximation();
  }
  Row f{};
  for (std::size_t row = 0; row < 3; ++row) {
    f[row] = residual_bound(tube, row);
  }
  tube.halfwidth = std::max({2 * *std::max_element(f.begin(), f.end()), least_halfwidth, kLeastHalfwidth});
  std::array<double, 4> h{};
  for (std::size_t j = 0; j < 4; ++j) {
    h[j] = kSlack * (std::fabs(tube.slope[j]) * reach + (j == axis ? 0 : tube.halfwidth));
  }
  const std::array<Magnitudes, 2> m = {magnitudes(tube.premultiplied[0]), magnitudes(tube.premultiplied[1])};
  const auto e = jacobian_deviation(tube, m, others, h);
  tube.contraction = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    double sum = 0;
    for (const std::size_t j : others) {
      sum += e[j][row];
    }
    sum *= kSlack;
    // Krawczyk: the image f + E Z lies strictly inside Z.
    if (!((f[row] + sum * tube.halfwidth) * kSlack < tube.halfwidth)) {
      return std::nullopt;
    }
    tube.contraction = std::max(tube.contraction, sum);
  }
  bound_derivatives(tube, m, others, h, e);
  tube.space_second_derivative = bound_space_second_derivative(tube, h);
  return tube;
}

template <class Ball>
std::optional<BallPoint<Ball>> newton_corrected(const PairSystem<Ball>& system, const BallPoint<Ball>& start,
                                                std::size_t axis, int steps) {
  const auto others = other_axes(axis);
  return newton_steps<Ball>(start, axis, steps, [&](const BallPoint<Ball>& p) {
    const Expansion<Ball> at(system, p);
    const auto c = preconditioner(at, others);
    return c ? std::optional(preconditioned(*c, at.value())) : std::nullopt;
  });
}

namespace {

/// C F(p + offset), by the premultiplied Taylor nets.
template <class Ball>
BallVector<Ball> premultiplied_value(const Tube<Ball>& tube, const BallPoint<Ball>& o) {
  BallVector<Ball> sum;
  for (std::size_t p = 0; p < 2; ++p) {
    const TaylorNet<Ball>& g = tube.premultiplied[p];
    const Ball& a = o[2 * p];
    const Ball& b = o[2 * p + 1];
    for (std::size_t row = 0; row < 3; ++row) {
      const Ball c0 = g[0][row] + b * (g[1][row] + b * g[2][row]);
      const Ball c1 = g[3][row] + b * (g[4][row] + b * g[5][row]);
      const Ball c2 = g[6][row] + b * (g[7][row] + b * g[8][row]);
      sum[row] += c0 + a * (c1 + a * c2);
    }
  }
  return sum;
}

}  // namespace

template <class Ball>
BallPoint<Ball> point_at(const Tube<Ball>& tube, double tau) {
  const auto others = other_axes(tube.axis);
  BallPoint<Ball> o;
  o[tube.axis] = Ball(tau);
  for (const std::size_t j : others) {
    o[j] = (Ball(tau) * Ball(tube.slope[j]) + Ball(0.5 * tau * tau) * Ball(tube.second[j])).midpoint();
  }
  // |w - w*| <= |C F(w)| / (1 - rho) for any w in the region; iterate w - C F(w) while that shrinks.
  auto [best_offset, best] = contracted<Ball>(
      o, tube.axis, [&](const BallPoint<Ball>& at) { return premultiplied_value(tube, at); });
  double radius = kSlack * best / (1 - tube.contraction);
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
BallVector<Ball> space_point(const Tube<Ball>& tube, const BallPoint<Ball>& parameters) {
  const Ball a = parameters[0] - tube.centre[0];
  const Ball b = parameters[1] - tube.centre[1];
  BallVector<Ball> result;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& x = tube.space;
    const Ball c0 = x[0][c] + b * (x[1][c] + b * x[2][c]);
    const Ball c1 = x[3][c] + b * (x[4][c] + b * x[5][c]);
    const Ball c2 = x[6][c] + b * (x[7][c] + b * x[8][c]);
    result[c] = c0 + a * (c1 + a * c2);
  }
  return result;
}

template <class Ball>
Ball offset(const Tube<Ball>& tube, const BallPoint<Ball>& point) {
  return point[tube.axis] - tube.centre[tube.axis];
}

template <class Ball>
bool contains(const Tube<Ball>& tube, const BallPoint<Ball>& box) {
  const Ball tau = offset(tube, box);
  if (!(tau.upper_magnitude() <= tube.reach)) {
    return false;
  }
  for (const std::size_t j : other_axes(tube.axis)) {
    const Ball from_line = box[j] - tube.centre[j] - tau * Ball(tube.slope[j]);
    if (!(from_line.upper_magnitude() <= tube.halfwidth)) {
      return false;
    }
  }
  return true;
}

template <class Ball>
bool excludes(const Tube<Ball>& tube, const BallPoint<Ball>& box) {
  const Ball tau = offset(tube, box);
  if (tau.lower_magnitude() > tube.reach) {
    return true;
  }
  const double middle = std::clamp(tau.approximation(), -tube.reach, tube.reach);
  const double spread = (tau - Ball(middle)).upper_magnitude();
  const BallPoint<Ball> w = point_at(tube, middle);
  for (const std::size_t j : other_axes(tube.axis)) {
    const double drift = kSlack * spread * (std::fabs(tube.slope[j]) + tube.slope_error[j]);
    if ((w[j].widened(drift) - box[j]).lower_magnitude() > 0) {
      return true;
    }
  }
  return false;
}

#define EXSECT_INSTANTIATE_TUBE(Ball)                                                                       \
  template std::optional<Tube<Ball>> certify_tube(const PairSystem<Ball>&, const BallPoint<Ball>&,          \
                                                  std::size_t, double, double);                             \
  template std::optional<BallPoint<Ball>> newton_corrected(const PairSystem<Ball>&, const BallPoint<Ball>&, \
                                                           std::size_t, int);                               \
  template BallPoint<Ball> point_at(const Tube<Ball>&, double);                                             \
  template BallVector<Ball> space_point(const Tube<Ball>&, const BallPoint<Ball>&);                         \
  template Ball offset(const Tube<Ball>&, const BallPoint<Ball>&);                                          \
  template bool contains(const Tube<Ball>&, const BallPoint<Ball>&);                                        \
  template bool excludes(const Tube<Ball>&, const BallPoint<Ball>&);

EXSECT_INSTANTIATE_TUBE(DoubleBall)
EXSECT_INSTANTIATE_TUBE(ArbBall<256>)
#undef EXSECT_INSTANTIATE_TUBE

}  // namespace exsect
