#include "lift/ball_chart.h"

#include <exsect/algebra/rounding_bounds.h>

#include <cmath>
#include <limits>

namespace exsect {
namespace {

/// The numerator of the derivative of a quotient.
Polynomial rate(const Polynomial& above, const Polynomial& below) {
  return above.derivative() * below - above * below.derivative();
}

/// The roots of the numbers of a ball that are not negative; 0 is one of them if none is.
DoubleBall root_in_balls(const DoubleBall& square) {
  constexpr double rounding = 0x1p-50;  // of the root, of the sum under it, and of the product
  const double upper = square.approximation() + square.radius();
  if (!(upper > 0)) return DoubleBall(0).widened(std::isnan(upper) ? upper : 0);
  const double lower = square.approximation() > 0 ? square.lower_magnitude() : 0;
  return DoubleBall::between(std::sqrt(lower) * (1 - rounding), std::sqrt(upper) * (1 + rounding));
}

}  // namespace

DoubleBall reciprocal(const DoubleBall& b) {  // |1/b - 1/m| <= r / (|m| (|m| - r))
  const double least = b.lower_magnitude();
  if (!(least > 0)) return {0, std::numeric_limits<double>::infinity()};
  const double middle = 1 / b.approximation();
  return DoubleBall(middle).widened((b.radius() / least + 0x1p-52) * std::fabs(middle) * kSlack);
}

QuadraticInBalls::QuadraticInBalls(const Polynomial& f) {
  for (int i = 0; i <= 2; ++i) c_[static_cast<std::size_t>(i)] = DoubleBall::enclosing(f.coefficient(i));
}

DoubleBall QuadraticInBalls::over(const DoubleBall& u) const {
  const DoubleBall at = u.midpoint();
  const DoubleBall slope = c_[1] + (c_[2] + c_[2]) * at;
  const double r = u.radius();
  return ((c_[2] * at + c_[1]) * at + c_[0])
      .widened((slope.upper_magnitude() + c_[2].upper_magnitude() * r) * r * kSlack + kUnderflowLoss);
}

BallChart::BallChart(const SurfaceChart& chart)
    : is_affine_(chart.is_affine()),
      radicand_in_u_(chart.radicand.at_s(0)),
      radicand_in_v_(chart.radicand.at_r(0) - Polynomial(chart.radicand.coefficient(0, 0))),
      height_(chart.height),
      width_(chart.width),
      denominator_(chart.denominator),
      height_rate_(rate(chart.height, chart.denominator)),
      width_rate_(rate(chart.width, chart.denominator)),
      middle_(DoubleBall::enclosing(chart.middle)) {
  const std::array<const Point*, 3> vectors = {&chart.along_u, &chart.along_v, &chart.along_y};
  for (std::size_t k = 0; k < 3; ++k) {
    origin_[k] = DoubleBall::enclosing(chart.origin[k]);
    for (std::size_t i = 0; i < 3; ++i) vectors_[i][k] = DoubleBall::enclosing((*vectors[i])[k]);
  }
}

DoubleBall BallChart::y_over(const DoubleBall& u, const DoubleBall& v, int sheet) const {
  return sheet == 0 ? DoubleBall() : y_of(square_over(u, v), sheet);
}

DoubleBall BallChart::square_over(const DoubleBall& u, const DoubleBall& v) const {
  return radicand_in_u_.over(u) + radicand_in_v_.over(v);
}

DoubleBall BallChart::y_of(const DoubleBall& square, int sheet) {
  if (sheet == 0) return {};
  const DoubleBall root = root_in_balls(square);
  return sheet > 0 ? root : -root;
}

BallChart::Place BallChart::along_axes(const Place& at) const {
  if (is_affine_) return at;
  const DoubleBall once = reciprocal(denominator_.over(at[0])), width = width_.over(at[0]) * once;
  return {height_.over(at[0]) * once, width * (at[1] - middle_), width * at[2]};
}

std::array<DoubleBall, 3> BallChart::in_space(const Place& along) const {
  std::array<DoubleBall, 3> point = origin_;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) point[k] += vectors_[i][k] * along[i];
  return point;
}

BallChart::Place BallChart::tangent_along_axes(const Place& tangent, const Place& at) const {
  if (is_affine_) return tangent;
  const DoubleBall once = reciprocal(denominator_.over(at[0])), width = width_.over(at[0]) * once;
  const DoubleBall du = tangent[0] * once * once, dw = width_rate_.over(at[0]) * du;
  return {height_rate_.over(at[0]) * du, width * tangent[1] + (at[1] - middle_) * dw,
          width * tangent[2] + at[2] * dw};
}

}  // namespace exsect
