#include "tube.h"

#include <algorithm>
#include <cmath>

#include "preconditioned_newton.h"

namespace exsect {

namespace {

// Factor that covers rounding in sums of nonnegative terms: fewer than 128 terms, each a product of at most
// six factors, lose less than (1 - 2^-53)^140 > 1 - 2^-45; underflow loses less than 2^-1000, far below every
// half width (2^-199).
constexpr double kSlack = 1 + 0x1p-40;

/// Tubes are wide enough to contain the boxes of landmarks and fibre points, of widths 2^-50 and 2^-200.
template <class Ball>
constexpr double kLeastHalfwidth = 0x1p-49;
template <>
inline constexpr double kLeastHalfwidth<ArbBall<256>> = 0x1p-199;

/// Half widths that are tried, each time this much wider than the image of the last ones.
constexpr int kMostWidths = 5;
constexpr double kWidening = 1.5;
constexpr int kRowSteps = 4;
/// Tubes are wider than their points are uncertain, by this factor, so that these are known to be inside.
constexpr double kRoom = 8;

using Row = Row3;

/// Taylor index of the first derivative that column j of the Jacobian is made of.
constexpr std::size_t column_index(std::size_t j) { return j % 2 == 0 ? 3 : 1; }

template <class Ball>
std::optional<BallMatrix<Ball>> preconditioner(const Expansion<Ball>& at,
                                               const std::array<std::size_t, 3>& others) {
  return approximate_inverse<Ball>({at.column(others[0]), at.column(others[1]), at.column(others[2])});
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

/// Bounds of the variation of the two first derivatives of a biquadratic net.
struct Variation {
  double first;
  double second;
};

/// The first derivatives of a biquadratic net along the line tau (da, db): for each of the two the magnitudes
/// of the coefficients of tau, tau² and tau³, by rows. Where two branches run side by side the net has large
/// coefficients that cancel along them.
struct AlongLine {
  std::array<Row, 3> first{};
  std::array<Row, 3> second{};
};
template <class Ball>
AlongLine along_line(const TaylorNet<Ball>& g, const Ball& da, const Ball& db) {
  AlongLine result;
  const Ball two(2);
  for (std::size_t row = 0; row < 3; ++row) {
    const auto c = [&](std::size_t k) { return g[k][row]; };
    result.first[0][row] = (two * c(6) * da + c(4) * db).upper_magnitude();
    result.first[1][row] = (two * c(7) * da * db + c(5) * db * db).upper_magnitude();
    result.first[2][row] = (two * c(8) * da * db * db).upper_magnitude();
    result.second[0][row] = (two * c(2) * db + c(4) * da).upper_magnitude();
    result.second[1][row] = (two * c(5) * da * db + c(7) * da * da).upper_magnitude();
    result.second[2][row] = (two * c(8) * da * da * db).upper_magnitude();
  }
  return result;
}

/// |sum of coefficient times tau^k| for |tau| <= reach.
double along(const std::array<Row, 3>& coefficient, std::size_t row, double reach) {
  return reach * (coefficient[0][row] + reach * (coefficient[1][row] + reach * coefficient[2][row]));
}

/// Bounds of the difference of the first derivatives at tau (da, db) + (ea, eb) and on the line, |tau da| <=
/// la, |ea| <= za and so on: products of sums less products of their first terms.
Variation off_line(const Magnitudes& m, std::size_t row, double la, double lb, double za, double zb) {
  const double ha = la + za;
  const double hb = lb + zb;
  const double ab = za * hb + la * zb;
  return {2 * m[6][row] * za + m[4][row] * zb + 2 * m[7][row] * ab + m[5][row] * zb * (hb + lb) +
              2 * m[8][row] * (za * hb * hb + la * zb * (hb + lb)),
          2 * m[2][row] * zb + m[4][row] * za + 2 * m[5][row] * ab + m[7][row] * za * (ha + la) +
              2 * m[8][row] * (zb * ha * ha + lb * za * (ha + la))};
}

Variation variation(const Magnitudes& m, std::size_t row, double ha, double hb) {
  return {2 * m[6][row] * ha + m[4][row] * hb + 2 * m[7][row] * ha * hb + m[5][row] * hb * hb +
              2 * m[8][row] * ha * hb * hb,
          2 * m[2][row] * hb + m[4][row] * ha + 2 * m[5][row] * ha * hb + m[7][row] * ha * ha +
              2 * m[8][row] * ha * ha * hb};
}

/// One row of the quadratic form of second derivatives at w' = d (signed, at the centre) is twice this.
template <class Ball>
Ball quadratic_term(const TaylorNet<Ball>& g, std::size_t row, const Ball& da, const Ball& db) {
  return g[6][row] * (da * da) + g[4][row] * (da * db) + g[2][row] * (db * db);
}

/// Bound of the deviation of the quadratic form D2(box)[w', w'] from its value at the centre with w' = d, one
/// patch: by D2[d] delta twice, D2[delta, delta], and the change of D2 over the box.
double quadratic_deviation(const Magnitudes& m, const AlongLine& line, std::size_t row, const double* d,
                           const double* delta, const double* h) {
  const double a0 = std::fabs(d[0]) + delta[0];
  const double a1 = std::fabs(d[1]) + delta[1];
  const double at_centre = 2 * (line.first[0][row] * delta[0] + line.second[0][row] * delta[1]) +
                           2 * (m[6][row] * delta[0] * delta[0] + m[4][row] * delta[0] * delta[1] +
                                m[2][row] * delta[1] * delta[1]);
  const double higher = 2 * (m[7][row] * h[1] + m[8][row] * h[1] * h[1]) * a0 * a0 +
                        4 * (m[7][row] * h[0] + m[5][row] * h[1] + 2 * m[8][row] * h[0] * h[1]) * a0 * a1 +
                        2 * (m[5][row] * h[0] + m[8][row] * h[0] * h[0]) * a1 * a1;
  return at_centre + higher;
}

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
    linear += g[3][row] * tube.direction[2 * p] + g[1][row] * tube.direction[2 * p + 1];
    second += quadratic_term(g, row, tube.direction[2 * p], tube.direction[2 * p + 1]);
    cubic += std::fabs(da * da * db) * g[7][row].upper_magnitude() +
             std::fabs(da * db * db) * g[5][row].upper_magnitude();
    quartic += da * da * db * db * g[8][row].upper_magnitude();
  }
  quadratic = second.upper_magnitude();
  const double t = tube.reach;
  return kSlack * (constant.upper_magnitude() +
                   t * (linear.upper_magnitude() + t * (quadratic + t * (cubic + t * quartic))));
}

/// Bound of |tau d_j|.
template <class Ball>
double on_line(const Tube<Ball>& tube, std::size_t j) {
  return kSlack * std::fabs(tube.slope[j]) * tube.reach;
}

/// |C D_j(box) - ideal| by rows, ideal = identity for j != axis and -d for j = axis.
template <class Ball>
std::array<Row, 4> jacobian_deviation(const Tube<Ball>& tube, const std::array<Magnitudes, 2>& m,
                                      const std::array<AlongLine, 2>& lines,
                                      const std::array<std::size_t, 3>& others) {
  std::array<Row, 4> e{};
  for (std::size_t p = 0; p < 2; ++p) {
    const double la = on_line(tube, 2 * p);
    const double lb = on_line(tube, 2 * p + 1);
    for (std::size_t row = 0; row < 3; ++row) {
      const Variation v = off_line(m[p], row, la, lb, tube.halfwidth[2 * p], tube.halfwidth[2 * p + 1]);
      e[2 * p][row] = along(lines[p].first, row, tube.reach) + v.first;
      e[2 * p + 1][row] = along(lines[p].second, row, tube.reach) + v.second;
    }
  }
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t row = 0; row < 3; ++row) {
      const Ball entry = tube.premultiplied[j / 2][column_index(j)][row];
      const Ball ideal = j == tube.axis ? -tube.direction[others[row]] : Ball(others[row] == j ? 1.0 : 0.0);
      e[j][row] = kSlack * ((entry - ideal).upper_magnitude() + e[j][row]);
    }
  }
  return e;
}

/// base + E bound, by rows.
Row through(const std::array<Row, 4>& e, const std::array<std::size_t, 3>& others, const Row& base,
            const Row& bound) {
  Row result{};
  for (std::size_t row = 0; row < 3; ++row) {
    double sum = base[row];
    for (std::size_t i = 0; i < 3; ++i) {
      sum += e[others[i]][row] * bound[i];
    }
    result[row] = kSlack * sum;
  }
  return result;
}

/// Bounds of |t| for any t with |t_i| <= base_i + sum E_ij |t_j|: the largest one first, by rho, and then row
/// by row, since the rows may be of very different size.
Row bound_solution(const std::array<Row, 4>& e, const std::array<std::size_t, 3>& others, const Row& base,
                   double contraction) {
  const double largest = *std::max_element(base.begin(), base.end());
  Row bound;
  for (std::size_t row = 0; row < 3; ++row) {
    bound[row] = kSlack * (base[row] + contraction / (1 - contraction) * kSlack * largest);
  }
  for (int step = 0; step < kRowSteps; ++step) {
    const Row next = through(e, others, base, bound);
    for (std::size_t row = 0; row < 3; ++row) {
      bound[row] = std::min(bound[row], next[row]);
    }
  }
  return bound;
}

template <class Ball>
void bound_derivatives(Tube<Ball>& tube, const std::array<Magnitudes, 2>& m,
                       const std::array<AlongLine, 2>& lines, const std::array<std::size_t, 3>& others,
                       const std::array<double, 4>& h, const std::array<Row, 4>& e) {
  Row g{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t j = 0; j < 4; ++j) {
      g[row] += e[j][row] * std::fabs(tube.slope[j]) * (1 + 0x1p-50);
    }
  }
  const Row first = bound_solution(e, others, g, tube.contraction);
  tube.slope_error = {};
  for (std::size_t row = 0; row < 3; ++row) {
    const double rounding = 0x1p-52 * std::fabs(tube.slope[others[row]]);  // of d to doubles
    tube.slope_error[others[row]] = kSlack * (first[row] + rounding);
  }
  Row deviation{};
  Row base{};
  tube.second = {};
  tube.second_error = {};
  for (std::size_t row = 0; row < 3; ++row) {
    Ball form;
    for (std::size_t p = 0; p < 2; ++p) {
      form += quadratic_term(tube.premultiplied[p], row, tube.direction[2 * p], tube.direction[2 * p + 1]);
      deviation[row] +=
          quadratic_deviation(m[p], lines[p], row, &tube.slope[2 * p], &tube.slope_error[2 * p], &h[2 * p]);
    }
    const double centre = form.approximation();
    deviation[row] += 2 * (form - Ball(centre)).upper_magnitude();
    tube.second[others[row]] = -2 * centre;
    base[row] = kSlack * (std::fabs(2 * centre) + deviation[row]);
  }
  const Row second_error = through(e, others, deviation, bound_solution(e, others, base, tube.contraction));
  for (std::size_t row = 0; row < 3; ++row) {
    tube.second_error[others[row]] = second_error[row];
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

/// About how well points of the curve on the tube can be enclosed.
template <class Ball>
double uncertainty(const Tube<Ball>& tube) {
  BallPoint<Ball> end;
  for (std::size_t j = 0; j < 4; ++j) {
    end[j] = (Ball(tube.reach) * tube.direction[j]).midpoint();
  }
  const BallVector<Ball> f = premultiplied_value(tube, end);
  return std::max({largest_magnitude(premultiplied_value(tube, BallPoint<Ball>{})), f[0].radius(),
                   f[1].radius(), f[2].radius()});
}

/// Bounds of |w_j - p_j| over the tube's region.
template <class Ball>
std::array<double, 4> farthest(const Tube<Ball>& tube) {
  std::array<double, 4> h{};
  for (std::size_t j = 0; j < 4; ++j) {
    h[j] = kSlack * (on_line(tube, j) + tube.halfwidth[j]);
  }
  return h;
}

/// The image f + E Z of Krawczyk's operator by rows, whether it lies strictly inside Z, and the largest row
/// sum of E.
struct Image {
  Row bound;
  bool inside;
  double contraction;
};
template <class Ball>
Image krawczyk_image(const Tube<Ball>& tube, const std::array<std::size_t, 3>& others, const Row& f,
                     const std::array<Row, 4>& e) {
  Image image{{}, true, 0};
  for (std::size_t row = 0; row < 3; ++row) {
    double sum = 0;
    double reached = f[row];
    for (const std::size_t j : others) {
      sum += e[j][row];
      reached += e[j][row] * tube.halfwidth[j];
    }
    image.bound[row] = kSlack * reached;
    image.inside = image.inside && image.bound[row] < tube.halfwidth[others[row]];
    image.contraction = std::max(image.contraction, kSlack * sum);
  }
  return image;
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
  tube.direction[axis] = Ball(1);
  for (std::size_t row = 0; row < 3; ++row) {
    tube.direction[others[row]] = -tube.premultiplied[axis / 2][column_index(axis)][row].midpoint();
  }
  for (std::size_t j = 0; j < 4; ++j) {
    tube.slope[j] = tube.direction[j].approximation();
  }
  Row f{};
  for (std::size_t row = 0; row < 3; ++row) {
    f[row] = residual_bound(tube, row);
  }
  const double least = std::max({least_halfwidth, kLeastHalfwidth<Ball>, kRoom * uncertainty(tube)});
  tube.halfwidth = {};
  for (std::size_t row = 0; row < 3; ++row) {
    tube.halfwidth[others[row]] = std::max(2 * f[row], least);
  }
  const std::array<Magnitudes, 2> m = {magnitudes(tube.premultiplied[0]), magnitudes(tube.premultiplied[1])};
  const std::array<AlongLine, 2> lines = {
      along_line(tube.premultiplied[0], tube.direction[0], tube.direction[1]),
      along_line(tube.premultiplied[1], tube.direction[2], tube.direction[3])};
  for (int attempt = 0; attempt < kMostWidths; ++attempt) {
    const auto e = jacobian_deviation(tube, m, lines, others);
    const Image image = krawczyk_image(tube, others, f, e);
    tube.contraction = image.contraction;
    if (!(image.contraction < 1)) {
      return std::nullopt;
    }
    if (image.inside) {
      tube.deviation = e;
      const std::array<double, 4> h = farthest(tube);
      bound_derivatives(tube, m, lines, others, h, e);
      tube.space_second_derivative = bound_space_second_derivative(tube, h);
      return tube;
    }
    for (std::size_t row = 0; row < 3; ++row) {
      double& z = tube.halfwidth[others[row]];
      z = std::max(z, kWidening * image.bound[row]);
    }
  }
  return std::nullopt;
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

template <class Ball>
BallPoint<Ball> point_at(const Tube<Ball>& tube, double tau, double enough) {
  const auto others = other_axes(tube.axis);
  BallPoint<Ball> o;
  o[tube.axis] = Ball(tau);
  for (const std::size_t j : others) {
    o[j] = (Ball(tau) * tube.direction[j] + Ball(0.5 * tau * tau) * Ball(tube.second[j])).midpoint();
  }
  // |w - w*| <= |C F(w)| + E |w - w*| for any w in the region; iterate w - C F(w) while that shrinks.
  const auto [best_offset, residual] = contracted<Ball>(
      o, tube.axis, [&](const BallPoint<Ball>& at) { return premultiplied_value(tube, at); }, enough);
  const Row radius = bound_solution(tube.deviation, others, residual, tube.contraction);
  bool inside = true;
  for (const std::size_t j : others) {
    const Ball from_line = best_offset[j] - Ball(tau) * tube.direction[j];
    inside = inside && from_line.upper_magnitude() <= tube.halfwidth[j];
  }
  BallPoint<Ball> result;
  result[tube.axis] = tube.centre[tube.axis] + Ball(tau);
  for (std::size_t row = 0; row < 3; ++row) {
    const std::size_t j = others[row];
    // The bound holds in the region only; the region itself is an enclosure.
    result[j] = tube.centre[j] + (inside ? best_offset[j].widened(radius[row])
                                         : (Ball(tau) * tube.direction[j]).widened(tube.halfwidth[j]));
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
    const Ball from_line = box[j] - tube.centre[j] - tau * tube.direction[j];
    if (!(from_line.upper_magnitude() <= tube.halfwidth[j])) {
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
  template BallPoint<Ball> point_at(const Tube<Ball>&, double, double);                                     \
  template BallVector<Ball> space_point(const Tube<Ball>&, const BallPoint<Ball>&);                         \
  template Ball offset(const Tube<Ball>&, const BallPoint<Ball>&);                                          \
  template bool contains(const Tube<Ball>&, const BallPoint<Ball>&);                                        \
  template bool excludes(const Tube<Ball>&, const BallPoint<Ball>&);

EXSECT_INSTANTIATE_TUBE(DoubleBall)
EXSECT_INSTANTIATE_TUBE(ArbBall<256>)
#undef EXSECT_INSTANTIATE_TUBE

}  // namespace exsect
