#include "trace/sheet_contraction.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

namespace exsect {

namespace {

using Net = SheetContraction::Net;
using Matrix = SheetContraction::Matrix;
using Pair = SheetContraction::Pair;

constexpr double kSameSheet = 1e-6;  // filters only: what is worth a proof
constexpr double kFarthest = 0.5;

double upper(const DoubleBall& b) { return b.upper_magnitude(); }

BallVector<double> approximations(const BallVector<DoubleBall>& v) {
  return {v[0].approximation(), v[1].approximation(), v[2].approximation()};
}

/// The rows that take y_r, y_s to the unit vectors and the normal to zero; empty if they are dependent.
std::optional<Matrix> left_inverse(const Net& y) {
  const auto a = approximations(y[3]);
  const auto b = approximations(y[1]);
  const BallVector<double> n = cross(a, b);
  const double length2 = dot(n, n);
  if (!(length2 > 1e-40)) return std::nullopt;
  const BallVector<double> first = cross(b, n);
  const BallVector<double> second = cross(n, a);
  Matrix c{};
  for (std::size_t k = 0; k < 3; ++k) {
    c[0][k] = first[k] / length2;
    c[1][k] = second[k] / length2;
  }
  return c;
}

DoubleBall row(const Matrix& c, std::size_t k, const BallVector<DoubleBall>& v) {
  return DoubleBall(c[k][0]) * v[0] + DoubleBall(c[k][1]) * v[1] + DoubleBall(c[k][2]) * v[2];
}

/// |coefficients| of row k of C times the net.
std::array<double, 9> row_magnitudes(const Matrix& c, std::size_t k, const Net& net) {
  std::array<double, 9> m{};
  for (std::size_t i = 0; i < 9; ++i) m[i] = upper(row(c, k, net[i]));
  return m;
}

/// Bound of the deviation of the two first derivatives from their values at the centre over |a_i| <= h_i.
Pair row_variation(const std::array<double, 9>& m, const Pair& h) {
  return {kSlack * (2 * m[6] * h[0] + m[4] * h[1] + 2 * m[7] * h[0] * h[1] + m[5] * h[1] * h[1] +
                    2 * m[8] * h[0] * h[1] * h[1]),
          kSlack * (2 * m[2] * h[1] + m[4] * h[0] + 2 * m[5] * h[0] * h[1] + m[7] * h[0] * h[0] +
                    2 * m[8] * h[0] * h[0] * h[1])};
}

/// Bound of the deviation of the value.
double deviation(const std::array<double, 9>& m, const Pair& h) {
  double sum = 0;
  double power0 = 1;
  for (std::size_t i = 0; i < 3; ++i, power0 *= h[0]) {
    double power = power0;
    for (std::size_t j = 0; j < 3; ++j, power *= h[1])
      if (i + j > 0) sum += m[3 * i + j] * power;
  }
  return kSlack * sum;
}

}  // namespace

SheetContraction::SheetContraction(const SearchRegion& region) {
  for (std::size_t k = 0; k < 2; ++k) {
    c[k] = 0.5 * (region.lower[k] + region.upper[k]);
    reach[k] = kSlack * 0.5 * (region.upper[k] - region.lower[k]);
    middle[k] = 0.5 * (region.lower[k + 2] + region.upper[k + 2]);
    half[k] = kSlack * 0.5 * (region.upper[k + 2] - region.lower[k + 2]);
  }
}

BallPoint<DoubleBall> SheetContraction::centre() const { return {c[0], c[1], w0[0], w0[1]}; }

bool SheetContraction::find_centre(const PairSystem<DoubleBall>& system) {
  w0 = middle;
  x = system.taylor_x(centre());
  for (int i = 0; i < 4; ++i) {
    y = system.taylor_y(centre());
    const auto inv = left_inverse(y);
    if (!inv) return false;
    const BallVector<DoubleBall> d = {x[0][0] - y[0][0], x[0][1] - y[0][1], x[0][2] - y[0][2]};
    for (std::size_t k = 0; k < 2; ++k) {
      w0[k] += row(*inv, k, d).approximation();
      if (!(std::fabs(w0[k] - middle[k]) <= kFarthest)) return false;
    }
  }
  y = system.taylor_y(centre());
  const auto inv = left_inverse(y);
  if (!inv) return false;
  inverse = *inv;
  return true;
}

bool SheetContraction::is_near() const {
  const BallVector<DoubleBall> d = {x[0][0] - y[0][0], x[0][1] - y[0][1], x[0][2] - y[0][2]};
  return larger_bound(upper(d[0]), upper(d[1]), upper(d[2])) < kSameSheet;
}

bool SheetContraction::contracts() {
  Pair residual{};
  for (std::size_t k = 0; k < 2; ++k) {
    residual[k] = kSlack * (upper(row(inverse, k, x[0]) - row(inverse, k, y[0])) +
                            deviation(row_magnitudes(inverse, k, x), reach));
    const double needed = kSlack * (std::fabs(w0[k] - middle[k]) + half[k]);
    width[k] = larger_bound(needed, 1.5 * residual[k]);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const Pair change = row_variation(row_magnitudes(inverse, k, y), width);
    const std::array<std::size_t, 2> column = {3, 1};
    for (std::size_t l = 0; l < 2; ++l)
      e[k][l] = kSlack * (upper(row(inverse, k, y[column[l]]) - DoubleBall(k == l ? 1 : 0)) + change[l]);
    image[k] = kSlack * (residual[k] + e[k][0] * width[0] + e[k][1] * width[1]);
    if (!(image[k] < width[k])) return false;
  }
  return true;
}

double SheetContraction::contraction() const {
  double result = 0;
  for (std::size_t k = 0; k < 2; ++k)
    result = larger_bound(result, kSlack * (e[k][0] * width[0] + e[k][1] * width[1]) / width[k]);
  return result;
}

std::optional<SheetGraph> SheetContraction::graph() const {
  SheetGraph result{{}, inverse, width, kSlack * contraction()};
  for (std::size_t k = 0; k < 2; ++k) {
    const double reach_out = 0.5 * (image[k] + width[k]);
    const Pair ends = {w0[k] - reach_out, w0[k] + reach_out};
    for (const double end : ends)
      if (!(std::fabs(end - w0[k]) > kSlack * image[k] && kSlack * std::fabs(end - w0[k]) < width[k]))
        return std::nullopt;
    result.range[k] = {from_double(ends[0]), from_double(ends[1])};
  }
  return result.contraction < 1 ? std::optional(result) : std::nullopt;
}

bool SheetContraction::leaves_region() const {
  for (std::size_t k = 0; k < 2; ++k)
    if (std::fabs(w0[k] - middle[k]) > kSlack * (image[k] + half[k])) return true;
  return false;
}

std::array<std::array<DoubleBall, 2>, 2> SheetContraction::first_derivatives() const {
  std::array<std::array<DoubleBall, 2>, 2> d;
  for (std::size_t k = 0; k < 2; ++k) {
    const Pair change = row_variation(row_magnitudes(inverse, k, x), reach);
    d[k] = {row(inverse, k, x[3]).widened(change[0]), row(inverse, k, x[1]).widened(change[1])};
  }
  return d;
}

bool SheetContraction::is_regular() const {
  const auto d = first_derivatives();
  return (d[0][0] * d[1][1] - d[0][1] * d[1][0]).certain_sign() != 0;
}

DoubleBall SheetContraction::projected(std::size_t k, const BallVector<DoubleBall>& v) const {
  return row(inverse, k, v);
}

}  // namespace exsect
