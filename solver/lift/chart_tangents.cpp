#include "lift/chart_tangents.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "curve/taylor_shift.h"

namespace exsect {

EnclosedPolynomial::EnclosedPolynomial(const BivariatePolynomial& f, const Rational& unit)
    : row_(static_cast<std::size_t>(std::max(f.degree_s(), 0)) + 1) {
  for (const DoubleBall& c : enclosed_coefficients<DoubleBall>(f, unit)) {
    middles_.push_back(c.approximation());
    errors_.push_back(c.radius());
  }
  for (std::size_t i = 0; i < errors_.size(); ++i) errors_[i] += relative_error() * std::fabs(middles_[i]);
}

/// Of what the expansion takes: two operations for each step in either direction, and one for each sum.
double EnclosedPolynomial::relative_error() const {
  return static_cast<double>(2 * (middles_.size() / row_ + row_)) * kUnitRoundoff;
}

DoubleBall EnclosedPolynomial::over(const DoubleBall& u, const DoubleBall& v) const {
  const double x = u.approximation(), y = v.approximation();
  const double reach_u = u.upper_magnitude(), reach_v = v.upper_magnitude();
  std::vector<double> c = middles_;
  shift_to(c, row_, x, y);
  double errors = 0, others = 0, power_u = 1;
  for (std::size_t i = c.size(); i > 0; i -= row_) {
    double error = 0;
    for (std::size_t j = i; j-- > i - row_;) error = error * reach_v + errors_[j];
    errors = errors * reach_u + error;
  }
  for (std::size_t i = 0; i < c.size(); i += row_, power_u *= u.radius()) {
    double power = power_u;
    for (std::size_t j = 0; j < row_; ++j, power *= v.radius())
      if (i + j > 0) others += std::fabs(c[i + j]) * power;
  }
  const double lost = kUnderflowLoss * std::pow(1 + larger_bound(reach_u, reach_v),
                                                static_cast<double>(middles_.size() / row_ + row_));
  // After an overflow the radius is infinite or NaN.
  return DoubleBall(c[0], std::fabs(c[0]) * kUnitRoundoff)
      .widened((others + errors) * (1 + 4 * relative_error()) * kSlack + lost);
}

ChartTangents::ChartTangents(const BivariatePolynomial& g, const SurfaceChart& chart, bool is_planar)
    : is_planar_(is_planar),
      g_u_(g.derivative_r(), greatest_coefficient(g)),
      g_v_(g.derivative_s(), greatest_coefficient(g)),
      y2_u_(chart.radicand.derivative_r(), 1),
      y2_v_(chart.radicand.derivative_s(), 1) {}

ChartDerivatives ChartTangents::derivatives(const DoubleBall& u, const DoubleBall& v) const {
  return {g_u_.over(u, v), g_v_.over(u, v), y2_u_.over(u, v), y2_v_.over(u, v)};
}

std::array<DoubleBall, 3> ChartTangents::over(const ChartDerivatives& derivatives, const BallChart::Place& at,
                                              const BallChart& chart) const {
  const DoubleBall &a = derivatives.g_u, &b = derivatives.g_v;
  if (is_planar_) return chart.tangent_along_axes({b, -a, DoubleBall(0)}, at);
  const DoubleBall twice = at[2] + at[2];
  return chart.tangent_along_axes({twice * b, -(twice * a), derivatives.jacobian()}, at);
}

DoubleBall squares_between(const DoubleBall& from, const DoubleBall& to, const ChartDerivatives& at,
                           double du, double dv) {
  const double jacobian = at.jacobian().upper_magnitude();
  const auto change = [&](const DoubleBall& divisor, double length) {
    const double least = divisor.lower_magnitude();
    return least > 0 ? jacobian * length / least * kSlack + kUnderflowLoss
                     : std::numeric_limits<double>::infinity();
  };
  const double over_u = change(at.g_v, du), over_v = change(at.g_u, dv);
  return ((from + to) * DoubleBall(0.5)).widened((over_u < over_v ? over_u : over_v) / 2 * kSlack);
}

}  // namespace exsect
