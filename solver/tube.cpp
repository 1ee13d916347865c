#include "tube.h"

#include <algorithm>
#include <cmath>

#include "tube_evaluation.h"

namespace exsect {

namespace {

using namespace tubes;

/// Tubes are wide enough to contain the boxes of landmarks and fibre points, of widths 2^-50, 2^-100 and
/// 2^-200.
template <class Ball>
constexpr double kLeastHalfwidth = 0x1p-49;
template <>
inline constexpr double kLeastHalfwidth<DoubleDoubleBall> = 0x1p-99;
template <>
inline constexpr double kLeastHalfwidth<ArbBall<256>> = 0x1p-199;

/// Half widths that are tried, each time this much wider than the image of the last ones.
constexpr int kMostWidths = 5;
constexpr double kWidening = 1.5;
/// Tubes are wider than their points are uncertain, by this factor, so that these are known to be inside.
constexpr double kRoom = 8;

using Row = Row3;

/// The longer one of the two normal vectors, of length about 1, and two axes of space: an invertible matrix,
/// or the identity where both normal vectors vanish.
template <class Ball>
BallMatrix<Ball> normal_basis(const Expansion<Ball>& at) {
  const BallVector<Ball> nx = cross(at.x[3], at.x[1]);
  const BallVector<Ball> ny = cross(at.y[3], at.y[1]);
  const BallVector<Ball>& n = largest_magnitude(nx) > largest_magnitude(ny) ? nx : ny;
  std::size_t largest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (std::fabs(n[k].approximation()) > std::fabs(n[largest].approximation())) {
      largest = k;
    }
  }
  BallMatrix<Ball> basis;
  for (std::size_t k = 0; k < 3; ++k) {
    basis[k][k] = Ball(1);
  }
  const double length = std::fabs(n[largest].approximation());
  if (length > 0x1p-100) {
    const Ball scale(std::ldexp(1.0, -std::ilogb(length)));
    basis[largest] = {(scale * n[0]).midpoint(), (scale * n[1]).midpoint(), (scale * n[2]).midpoint()};
  }
  return basis;
}

template <class Ball>
OffLine off_line(const Tube<Ball>& tube, const AlongLine& along, std::size_t p, std::size_t row,
                 double SeriesBound::*part) {
  return {along.derivative[p][row], part, tube.halfwidth[2 * p], tube.halfwidth[2 * p + 1]};
}

/// By columns other than the axis: |C D_j - 1|, or its derivative with respect to tau.
template <class Ball>
std::array<Row, 4> column_bounds(const Tube<Ball>& tube, const AlongLine& along, double SeriesBound::*part) {
  std::array<Row, 4> e{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t p = 0; p < 2; ++p) {
      const OffLine off = off_line(tube, along, p, row, part);
      e[2 * p][row] = kSlack * off.first_a();
      e[2 * p + 1][row] = kSlack * off.first_b();
    }
  }
  e[tube.axis] = {};
  return e;
}

/// w = p + l + e with C F(p + l + e) = 0: e' and e'' solve the equations differentiated once and twice.
template <class Ball>
void bound_derivatives(Tube<Ball>& tube, const AlongLine& along) {
  const auto others = other_axes(tube.axis);
  Row base{};
  for (std::size_t row = 0; row < 3; ++row) {
    base[row] = along.residual[row].first;
    for (std::size_t p = 0; p < 2; ++p) {
      base[row] += off_line(tube, along, p, row, &SeriesBound::first).value();
    }
    base[row] *= kSlack;
  }
  const Row first = bound_solution(tube.deviation, others, base, tube.contraction);
  std::array<double, 4> e1{};
  for (std::size_t row = 0; row < 3; ++row) {
    e1[others[row]] = first[row];
  }
  const std::array<Row, 4> change = column_bounds(tube, along, &SeriesBound::first);
  for (std::size_t row = 0; row < 3; ++row) {
    base[row] = along.residual[row].second;
    for (std::size_t p = 0; p < 2; ++p) {
      base[row] += off_line(tube, along, p, row, &SeriesBound::second).value() +
                   off_line(tube, along, p, row, &SeriesBound::value).quadratic(e1[2 * p], e1[2 * p + 1]);
    }
    for (const std::size_t j : others) {
      base[row] += 2 * change[j][row] * e1[j];
    }
    base[row] *= kSlack;
  }
  const Row second = bound_solution(tube.deviation, others, base, tube.contraction);
  tube.slope_error = tube.second = tube.second_error = {};
  for (std::size_t row = 0; row < 3; ++row) {
    const std::size_t j = others[row];
    const double rounding = 0x1p-51;  // of d and of the coefficient of sigma² to doubles
    tube.slope_error[j] = kSlack * (along.bend[j].first + first[row] + rounding * std::fabs(tube.slope[j]));
    tube.second[j] = 2 * tube.line[1][j].approximation() / (tube.scale * tube.scale);
    tube.second_error[j] =
        kSlack * (along.higher_bend[j].second + second[row] + rounding * std::fabs(tube.second[j]));
  }
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

Variation variation(const Magnitudes& m, std::size_t row, double ha, double hb) {
  return {2 * m[6][row] * ha + m[4][row] * hb + 2 * m[7][row] * ha * hb + m[5][row] * hb * hb +
              2 * m[8][row] * ha * hb * hb,
          2 * m[2][row] * hb + m[4][row] * ha + 2 * m[5][row] * ha * hb + m[7][row] * ha * ha +
              2 * m[8][row] * ha * ha * hb};
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
  double largest = 0;
  for (const double tau : {0.0, tube.reach}) {
    const Ball sigma(tau / tube.scale);
    BallPoint<Ball> at;
    for (std::size_t j = 0; j < 4; ++j) {
      at[j] = on_line(tube, j, sigma).midpoint();
    }
    const BallVector<Ball> f = premultiplied_value(tube, preconditioner_at(tube, sigma), at);
    largest = std::max({largest, f[0].radius(), f[1].radius(), f[2].radius()});
  }
  return largest;
}

/// Bounds of |w_j - p_j| over the tube's region.
template <class Ball>
std::array<double, 4> farthest(const Tube<Ball>& tube, const AlongLine& along) {
  std::array<double, 4> h{};
  for (std::size_t j = 0; j < 4; ++j) {
    const double slope = tube.line[0][j].upper_magnitude() / tube.scale;
    h[j] = kSlack * (kSlack * slope * tube.reach + along.bend[j].value + tube.halfwidth[j]);
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

/// Proves the tube around its line, if its bounds allow it.
template <class Ball>
bool certify(Tube<Ball>& tube, const AlongLine& along, double least_halfwidth) {
  const auto others = other_axes(tube.axis);
  const double least = std::max({least_halfwidth, kLeastHalfwidth<Ball>, kRoom * uncertainty(tube)});
  Row f{};
  tube.halfwidth = {};
  for (std::size_t row = 0; row < 3; ++row) {
    f[row] = kSlack * along.residual[row].value;
    tube.halfwidth[others[row]] = std::max(2 * f[row], least);
  }
  for (int attempt = 0; attempt < kMostWidths; ++attempt) {
    const auto e = column_bounds(tube, along, &SeriesBound::value);
    const Image image = krawczyk_image(tube, others, f, e);
    tube.contraction = image.contraction;
    if (!(image.contraction < 1)) {
      return false;
    }
    if (image.inside) {
      tube.deviation = e;
      return true;
    }
    for (std::size_t row = 0; row < 3; ++row) {
      double& z = tube.halfwidth[others[row]];
      z = std::max(z, kWidening * image.bound[row]);
    }
  }
  return false;
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
  tube.orientation = at.tangent()[axis].certain_sign();
  if (tube.orientation == 0) {
    return std::nullopt;
  }
  const BallMatrix<Ball> basis = normal_basis(at);
  tube.space = at.x;
  for (std::size_t i = 0; i < 9; ++i) {
    tube.nets[0][i] = preconditioned(basis, at.x[i]);
    tube.nets[1][i] = preconditioned(basis, BallVector<Ball>{-at.y[i][0], -at.y[i][1], -at.y[i][2]});
  }
  const std::optional<AlongLine> along = fit_line(tube);
  if (!along || !certify(tube, *along, least_halfwidth)) {
    return std::nullopt;
  }
  bound_derivatives(tube, *along);
  tube.space_second_derivative = bound_space_second_derivative(tube, farthest(tube, *along));
  return tube;
}

template <class Ball>
std::optional<BallPoint<Ball>> newton_corrected(const PairSystem<Ball>& system, const BallPoint<Ball>& start,
                                                std::size_t axis, int steps) {
  const auto others = other_axes(axis);
  return newton_steps<Ball>(start, axis, steps, [&](const BallPoint<Ball>& p) {
    const Expansion<Ball> at(system, p);
    const auto c =
        approximate_inverse<Ball>({at.column(others[0]), at.column(others[1]), at.column(others[2])});
    return c ? std::optional(preconditioned(*c, at.value())) : std::nullopt;
  });
}

#define EXSECT_INSTANTIATE_TUBE(Ball)                                                                       \
  template std::optional<Tube<Ball>> certify_tube(const PairSystem<Ball>&, const BallPoint<Ball>&,          \
                                                  std::size_t, double, double);                             \
  template std::optional<BallPoint<Ball>> newton_corrected(const PairSystem<Ball>&, const BallPoint<Ball>&, \
                                                           std::size_t, int);

EXSECT_INSTANTIATE_TUBE(DoubleBall)
EXSECT_INSTANTIATE_TUBE(DoubleDoubleBall)
EXSECT_INSTANTIATE_TUBE(ArbBall<256>)
#undef EXSECT_INSTANTIATE_TUBE

}  // namespace exsect
