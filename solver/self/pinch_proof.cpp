#include "self/pinch_proof.h"

#include <algorithm>
#include <cmath>

#include "self/chart.h"
#include "self/pinch_matrix.h"

namespace exsect {
namespace {

using Ball = DoubleBall;
using Vector = BallVector<DoubleBall>;

constexpr int kSteps = 100;
constexpr int kRefinements = 8;

}  // namespace

std::optional<PinchProof> PinchProof::of(const RationalPatch& patch, const Point& origin) {
  LocalDerivatives x(patch, origin);
  const AffineDerivatives centre = x.at(Ball(0.5), Ball(0.5));
  const bool exchanged = is_exchanged(centre);
  if (exchanged) x = LocalDerivatives(patch.transposed(), origin);
  PinchProof result(std::move(x), exchanged);
  if (!result.prove()) return std::nullopt;
  return result;
}

bool PinchProof::prove() {
  const AffineDerivatives d = x_.everywhere();
  const auto slopes = slopes_of(x_.at(Ball(0.5), Ball(0.5)), d);
  if (!slopes) return false;
  guess_ = slopes->guess;
  slopes_ = slopes->all;
  const CurveBounds bounds(d, slopes_);
  if (!invert(bounds.columns())) return false;
  bound_curves(bounds);
  return true;
}

/// (14.62): P z < z for P = |C J - 1|.
bool PinchProof::invert(const std::array<Vector, 3>& columns) {
  rows_ = inverse(columns);
  auto& p = deviations_;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      p[i][j] = (product(rows_[i], columns[j]) - Ball(i == j ? 1 : 0)).upper_magnitude();
  scale_ = {1, 1, 2 * (p[2][0] + p[2][1]) / (1 - p[2][2]) + 0x1p-40};
  for (std::size_t i = 0; i < 3; ++i) {
    const double used = (p[i][0] * scale_[0] + p[i][1] * scale_[1] + p[i][2] * scale_[2]) * kSlack;
    room_[i] = (scale_[i] - used) * kReduced;
    if (!(used < scale_[i]) || !(room_[i] > 0) || !(scale_[i] > 0)) return false;
  }
  return true;
}

/// A first bound of y by (14.62), then |y| <= |C value| + P |y| with the last bound on the right.
std::array<double, 3> PinchProof::solved(const Vector& value) const {
  std::array<double, 3> known, y;
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    known[i] = product(rows_[i], value).upper_magnitude();
    most = larger_bound(most, known[i] / room_[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) y[i] = most * scale_[i] * kSlack + kUnderflowLoss;
  for (int k = 0; k < kRefinements; ++k) {
    const std::array<double, 3> last = y;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& p = deviations_[i];
      const double next = known[i] + p[0] * last[0] + p[1] * last[1] + p[2] * last[2];
      y[i] = std::min(y[i], next * kSlack + kUnderflowLoss);
    }
  }
  return y;
}

/// (14.63), (14.64): derivatives by q = t^2 <= 1/4 of the midpoint, the slope and the point of space.
void PinchProof::bound_curves(const CurveBounds& bounds) {
  const Vector first = bounds.first();
  const std::array<double, 3> speed = speed_ = solved(first);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& p = deviations_[i];
    const double off = (p[0] * speed[0] + p[1] * speed[1] + p[2] * speed[2]) * kSlack + kUnderflowLoss;
    drift_[i] = Ball(0, off) - product(rows_[i], first);
  }
  monotone_ = {speed[0] * kSlack < 1, (speed[1] + 0.5 * speed[2]) * kSlack < slopes_.lower_magnitude()};
  bend_ = bounds.bend(speed, solved(bounds.second(speed)));
}

/// (14.74): the slope at the pinch point is 0 if the derivative by the first of the parameters that are used
/// here is.
bool PinchProof::is_monotone_from_rest(std::size_t parameter) const {
  const bool is_second = exchanged_ != (parameter == 1);
  return is_second && 0.75 * kSlack * speed_[2] < drift_[1].lower_magnitude();
}

/// (14.73)
PinchProof::AtSide PinchProof::at_side(std::size_t parameter, int value, bool rests, bool is_straight) const {
  if (is_monotone(parameter)) return AtSide::none;
  const bool is_second = exchanged_ != (parameter == 1);
  if (!rests || !is_second) return AtSide::unknown;
  if (is_straight) return AtSide::along;  // (14.73b)
  const Ball inwards = value == 0 ? drift_[1] : -drift_[1];
  if ((-inwards).is_positive()) return AtSide::none;
  return inwards.is_positive() && is_monotone_from_rest(parameter) ? AtSide::begins : AtSide::unknown;
}

Vector PinchProof::value_at(const std::array<double, 3>& y, double t) const {
  if (t == 0) {
    const AffineDerivatives d = x_.at(y[0], y[1]);
    return plus(d[1][0], Ball(y[2]), d[0][1]);
  }
  const Ball across = Ball(y[2]) * Ball(t);
  const Vector first = x_.at(Ball(y[0]) + Ball(t), Ball(y[1]) + across)[0][0];
  const Vector second = x_.at(Ball(y[0]) - Ball(t), Ball(y[1]) - across)[0][0];
  const Ball inverse = reciprocal(Ball(2 * t));
  return {(first[0] - second[0]) * inverse, (first[1] - second[1]) * inverse,
          (first[2] - second[2]) * inverse};
}

/// Newton's method with the inverse in the middle of the square, as long as it gets nearer.
bool PinchProof::improve(std::array<double, 3>& y, double t) const {
  double last = HUGE_VAL;
  for (int step = 0; step < kSteps; ++step) {
    const std::array<double, 3> value = middle(value_at(y, t));
    std::array<double, 3> change;
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      change[i] = product(rows_[i], value);
      size = std::max(size, std::fabs(change[i]) / scale_[i]);
    }
    if (!(size < last)) return std::isfinite(size);
    last = size;
    for (std::size_t i = 0; i < 3; ++i) y[i] -= change[i];
  }
  return true;
}

/// As far from the solution as (14.62) says: with both in the region, the difference of the values is J times
/// that of the places.
std::optional<PinchProof::Place> PinchProof::at(double t, std::optional<double> side) const {
  std::array<double, 3> y = {0.5, 0.5, guess_};
  if (!improve(y, t)) return std::nullopt;
  if (side) y = {y[0], *side, 0};
  if (t == 0)  // it may be on a side
    for (const std::size_t i : {0U, 1U}) y[i] = std::clamp(y[i], 0.0, 1.0);
  std::array<double, 3> off = solved(value_at(y, t));
  if (side) off[1] = off[2] = 0;
  const double reach = t * std::fabs(y[2]) * kSlack;
  const bool is_inside = y[0] - t >= 0 && y[0] + t <= 1 && y[1] - reach >= 0 && y[1] + reach <= 1;
  const Ball from_middle = Ball(y[2]) - slopes_.midpoint();
  if (!is_inside || !(from_middle.upper_magnitude() <= slopes_.radius())) return std::nullopt;
  if (!(off[0] <= 1 && off[1] <= 1)) return std::nullopt;
  const Ball u(y[0], off[0]), v(y[1], off[1]), across = Ball(y[2], off[2]) * Ball(t);
  Place result{{u + Ball(t), v + across, u - Ball(t), v - across}, {}};
  if (side) result.pair[1] = result.pair[3] = Ball(*side);
  result.point = x_.at(result.pair[0], result.pair[1])[0][0];
  if (exchanged_) result.pair = {result.pair[1], result.pair[0], result.pair[3], result.pair[2]};
  return result;
}

Vector PinchProof::point(const std::array<Ball, 2>& at) const {
  return exchanged_ ? x_.at(at[1], at[0])[0][0] : x_.at(at[0], at[1])[0][0];
}

}  // namespace exsect
