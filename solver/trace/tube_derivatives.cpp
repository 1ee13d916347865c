#include "trace/tube_derivatives.h"

#include <exsect/algebra/rounding_bounds.h>

#include <cmath>

#include "trace/tube.h"
#include "trace/tube_evaluation.h"

namespace exsect {

namespace {

using namespace tubes;
using Row = Row3;

template <class Ball>
OffLine off_line(const Tube<Ball>& tube, const AlongLine& along, std::size_t p, std::size_t row,
                 double SeriesBound::*part) {
  return {along.derivative[p][row], part, tube.halfwidth[2 * p], tube.halfwidth[2 * p + 1]};
}

/// Magnitudes of one Taylor net's coefficient rows: m[index][row].
using Magnitudes = std::array<Row, 9>;

template <class Ball>
Magnitudes net_magnitudes(const TaylorNet<Ball>& net) {
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
  const Magnitudes m = net_magnitudes(tube.space);
  const double a0 = std::fabs(tube.slope[0]) + tube.slope_error[0];
  const double a1 = std::fabs(tube.slope[1]) + tube.slope_error[1];
  const double u2 = std::fabs(tube.second[0]) + tube.second_error[0];
  const double v2 = std::fabs(tube.second[1]) + tube.second_error[1];
  Row3 bound{};
  for (std::size_t c = 0; c < 3; ++c) {
    const Variation v = variation(m, c, h[0], h[1]);
    const double xuu = 2 * (m[6][c] + m[7][c] * h[1] + m[8][c] * h[1] * h[1]);
    const double xuv = m[4][c] + 2 * m[7][c] * h[0] + 2 * m[5][c] * h[1] + 4 * m[8][c] * h[0] * h[1];
    const double xvv = 2 * (m[2][c] + m[5][c] * h[0] + m[8][c] * h[0] * h[0]);
    bound[c] = (m[3][c] + v.first) * u2 + (m[1][c] + v.second) * v2 + xuu * a0 * a0 + 2 * xuv * a0 * a1 +
               xvv * a1 * a1;
  }
  return kSlack * length_bound(bound[0], bound[1], bound[2]);
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

/// The derivative of l_i of order 1 or 2 with respect to tau between two offsets, widened by `remainder`: by
/// its Taylor coefficients at the middle.
template <class Ball>
ValueRange line_derivative(const Tube<Ball>& tube, std::size_t i, int order, double from, double to,
                           double remainder) {
  constexpr std::size_t degree = kLineDegree<Ball>;
  const double middle = 0.5 * (from + to) / tube.scale;
  const double half = 0.5 * std::fabs(to - from) / tube.scale;
  const double unit = order == 1 ? 1 / tube.scale : 1 / (tube.scale * tube.scale);
  std::array<double, degree> a{};
  double magnitude = 0;
  for (std::size_t k = 0; k < degree; ++k) {
    const double n = static_cast<double>(k);
    const std::size_t from_line = k + static_cast<std::size_t>(order) - 1;
    if (from_line < degree) {
      a[k] = (order == 1 ? n + 1 : (n + 2) * (n + 1)) * tube.line[from_line][i].approximation() * unit;
      magnitude += std::fabs(a[k]);
    }
  }
  double variation = 0;
  double power = 1;
  for (std::size_t j = 0; j < degree; ++j) {
    for (std::size_t k = degree - 1; k > j; --k) {
      a[k - 1] += middle * a[k];
    }
    variation += power * (j == 0 ? 0 : std::fabs(a[j]));
    power *= half;
  }
  // |middle| + half <= 1: fewer than 2^5 roundings in each of the terms whose magnitudes sum to `magnitude`;
  // a coefficient that underflows is multiplied by less than 2^20.
  return {a[0], kSlack * (variation + remainder) + 0x1p-46 * magnitude + kUnderflow * unit};
}

}  // namespace

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
  tube.slope_remainder = tube.second_remainder = {};
  for (std::size_t row = 0; row < 3; ++row) {
    const std::size_t j = others[row];
    const double rounding = 0x1p-51;  // of d and of the coefficient of sigma² to doubles
    const double lost = kUnderflow / tube.scale;
    tube.slope_remainder[j] = first[row];
    tube.second_remainder[j] = second[row];
    tube.slope_error[j] =
        kSlack * (along.bend[j].first + first[row] + rounding * std::fabs(tube.slope[j]) + lost);
    tube.second[j] = 2 * tube.line[1][j].approximation() / (tube.scale * tube.scale);
    tube.second_error[j] = kSlack * (along.higher_bend[j].second + second[row] +
                                     rounding * std::fabs(tube.second[j]) + lost / tube.scale);
  }
  tube.space_second_derivative = bound_space_second_derivative(tube, farthest(tube, along));
}

template <class Ball>
ValueRange slope_between(const Tube<Ball>& tube, std::size_t i, double from, double to) {
  return line_derivative(tube, i, 1, from, to, tube.slope_remainder[i]);
}

template <class Ball>
ValueRange second_between(const Tube<Ball>& tube, std::size_t i, double from, double to) {
  return line_derivative(tube, i, 2, from, to, tube.second_remainder[i]);
}

#define EXSECT_INSTANTIATE_DERIVATIVES(Ball)                                                             \
  template std::array<Row, 4> column_bounds(const Tube<Ball>&, const AlongLine&, double SeriesBound::*); \
  template ValueRange slope_between(const Tube<Ball>&, std::size_t, double, double);                     \
  template ValueRange second_between(const Tube<Ball>&, std::size_t, double, double);                    \
  template void bound_derivatives(Tube<Ball>&, const AlongLine&);

EXSECT_INSTANTIATE_DERIVATIVES(DoubleBall)
EXSECT_INSTANTIATE_DERIVATIVES(DoubleDoubleBall)
EXSECT_INSTANTIATE_DERIVATIVES(ArbBall<256>)
EXSECT_INSTANTIATE_DERIVATIVES(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_DERIVATIVES

}  // namespace exsect
