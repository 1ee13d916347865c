#include "self/pinch_bounds.h"

#include <exsect/algebra/rounding_bounds.h>

#include <cmath>

#include "self/chart.h"
#include "self/pinch_matrix.h"

namespace exsect {
namespace {

/// q.
const DoubleBall kSquares(0.125, 0.125);
const DoubleBall kSixth(1.0 / 6, 0x1p-54);
const DoubleBall kTwelfth(1.0 / 12, 0x1p-54);
const DoubleBall kSixtieth(1.0 / 60, 0x1p-54);

BallVector<DoubleBall> multiple(const DoubleBall& t, const BallVector<DoubleBall>& a) {
  return {t * a[0], t * a[1], t * a[2]};
}

DoubleBall up_to(double bound) { return {0, bound}; }

}  // namespace

BallVector<DoubleBall> plus(const BallVector<DoubleBall>& a, const DoubleBall& t,
                            const BallVector<DoubleBall>& b) {
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}

bool is_exchanged(const AffineDerivatives& centre) {
  const auto first = middle(centre[1][0]), second = middle(centre[0][1]);
  return product(first, first) > product(second, second);
}

namespace {

/// a + m b = 0 with means a, b of x_u, x_v, so that c.(a + g b) = (g - m) c.b for the guess g.
std::optional<DoubleBall> slopes_along(const std::array<double, 3>& c, double guess,
                                       const AffineDerivatives& d) {
  const DoubleBall along = product(c, d[0][1]);
  if (!along.is_positive()) return std::nullopt;
  const DoubleBall all =
      DoubleBall(guess) - product(c, plus(d[1][0], DoubleBall(guess), d[0][1])) * reciprocal(along);
  return std::isfinite(all.upper_magnitude()) ? std::optional(all) : std::nullopt;
}

}  // namespace

/// c is perpendicular to the second derivatives, where these are independent, or has the direction of x_v.
std::optional<Slopes> slopes_of(const AffineDerivatives& centre, const AffineDerivatives& d) {
  const auto first = middle(centre[1][0]), second = middle(centre[0][1]);
  const double size = product(second, second);
  const double guess = -product(first, second) / size;
  const DoubleBall m(guess);
  const auto rows =
      inverse({plus(centre[2][0], m, centre[1][1]), plus(centre[1][1], m, centre[0][2]), centre[0][1]});
  auto all = slopes_along(rows[2], guess, d);
  if (!all) all = slopes_along({second[0] / size, second[1] / size, second[2] / size}, guess, d);
  return all ? std::optional(Slopes{guess, *all}) : std::nullopt;
}

BallVector<DoubleBall> CurveBounds::along(std::size_t n, std::size_t i, std::size_t j) const {
  if (n == 0) return d_[i][j];
  return plus(along(n - 1, i + 1, j), m_, along(n - 1, i, j + 1));
}

std::array<BallVector<DoubleBall>, 3> CurveBounds::columns() const {
  return {along(1, 1, 0), along(1, 0, 1), d_[0][1]};
}

BallVector<DoubleBall> CurveBounds::first() const { return multiple(kSixth, along(3, 0, 0)); }

BallVector<DoubleBall> CurveBounds::second(const std::array<double, 3>& speed) const {
  const DoubleBall u = up_to(speed[0]), v = up_to(speed[1]), m = up_to(speed[2]);
  const DoubleBall two(2);
  Vector sum = multiple(kSixtieth, along(5, 0, 0));
  sum = plus(sum, two * u * kSixth, along(3, 1, 0));
  sum = plus(sum, two * v * kSixth, along(3, 0, 1));
  sum = plus(sum, m, along(2, 0, 1));
  sum = plus(sum, u * u, along(1, 2, 0));
  sum = plus(sum, two * u * v, along(1, 1, 1));
  sum = plus(sum, v * v, along(1, 0, 2));
  sum = plus(sum, two * u * m, d_[1][1]);
  sum = plus(sum, two * v * m, d_[0][2]);
  return plus(sum, m * m * kSquares, along(1, 0, 2));
}

double CurveBounds::bend(const std::array<double, 3>& speed, const std::array<double, 3>& change) const {
  const DoubleBall u = up_to(speed[0]), v = up_to(speed[1]), m = up_to(speed[2]);
  const DoubleBall two(2);
  Vector sum = multiple(kTwelfth, along(4, 0, 0));
  sum = plus(sum, u, along(2, 1, 0));
  sum = plus(sum, v, along(2, 0, 1));
  sum = plus(sum, two * m, plus(along(1, 0, 1), kSquares * kSixth, along(3, 0, 1)));
  sum = plus(sum, u * u, d_[2][0]);
  sum = plus(sum, two * u * v, d_[1][1]);
  sum = plus(sum, v * v, d_[0][2]);
  sum = plus(sum, two * u * m * kSquares, along(1, 1, 1));
  sum = plus(sum, two * v * m * kSquares, along(1, 0, 2));
  sum = plus(sum, m * m * kSquares, d_[0][2]);
  sum = plus(sum, up_to(change[0]), d_[1][0]);
  sum = plus(sum, up_to(change[1]), d_[0][1]);
  sum = plus(sum, up_to(change[2]) * kSquares, along(1, 0, 1));
  return length_bound(sum[0].upper_magnitude(), sum[1].upper_magnitude(), sum[2].upper_magnitude()) +
         kUnderflowLoss;
}

}  // namespace exsect
