#include "self/pinch_exclusion.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "self/pinch_bounds.h"
#include "self/pinch_matrix.h"

namespace exsect {
namespace {

constexpr int kNarrowings = 3;
/// Derivatives up to the third.
constexpr std::size_t kOrders = 4;

/// The part of a that may be in b; false if there is none.
bool narrow(DoubleBall& a, const DoubleBall& b) {
  const double lower = std::max(a.approximation() - a.radius(), b.approximation() - b.radius());
  const double upper = std::min(a.approximation() + a.radius(), b.approximation() + b.radius());
  const double room = 0x1p-50 * (a.upper_magnitude() + b.upper_magnitude()) + kUnderflowLoss;
  if (lower > upper + 2 * room) return false;
  a = DoubleBall(0.5 * lower + 0.5 * upper, 0.5 * std::fabs(upper - lower) * kSlack + 2 * room);
  return true;
}

/// What is left of the ranges of (U,V,m): y - c = -C H(c,0) - (C J - 1)(y - c) - q C H_q for a solution y.
bool is_narrowed_away(const std::array<DoubleBall, 3>& ranges, const std::array<double, 3>& at,
                      const BallVector<DoubleBall>& value, const CurveBounds& bounds) {
  const auto columns = bounds.columns();
  const auto rows = inverse(columns);
  const DoubleBall squares(0.125, 0.125);
  const BallVector<DoubleBall> change = bounds.first();
  std::array<DoubleBall, 3> left = ranges;
  for (int k = 0; k < kNarrowings; ++k) {
    const std::array<DoubleBall, 3> before = left;
    for (std::size_t i = 0; i < 3; ++i) {
      DoubleBall next = DoubleBall(at[i]) - product(rows[i], value) - squares * product(rows[i], change);
      for (std::size_t j = 0; j < 3; ++j)
        next -= (product(rows[i], columns[j]) - DoubleBall(i == j ? 1 : 0)) * (before[j] - DoubleBall(at[j]));
      if (std::isfinite(next.upper_magnitude()) && !narrow(left[i], next)) return true;
    }
  }
  return false;
}

}  // namespace

bool has_no_pairs(const RationalPatch& patch, const Point& origin,
                  const std::array<DoubleBall, 2>& midpoints) {
  LocalDerivatives x(patch, origin, kOrders);
  std::array<DoubleBall, 2> ranges = midpoints;
  AffineDerivatives centre = x.at(ranges[0].midpoint(), ranges[1].midpoint());
  if (is_exchanged(centre)) {
    x = LocalDerivatives(patch.transposed(), origin, kOrders);
    std::swap(ranges[0], ranges[1]);
    centre = x.at(ranges[0].midpoint(), ranges[1].midpoint());
  }
  const AffineDerivatives d = x.everywhere();
  const auto slopes = slopes_of(centre, d);
  if (!slopes) return false;
  const std::array<double, 3> at = {ranges[0].approximation(), ranges[1].approximation(), slopes->guess};
  const BallVector<DoubleBall> value = plus(centre[1][0], DoubleBall(at[2]), centre[0][1]);
  return is_narrowed_away({ranges[0], ranges[1], slopes->all}, at, value, CurveBounds(d, slopes->all));
}

}  // namespace exsect
