#include "lift/chart_tangents.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "curve/taylor_shift.h"

namespace exsect {

PolynomialInBalls::PolynomialInBalls(const BivariatePolynomial& f, const Rational& unit, int degree_r,
                                     int degree_s)
    : row_(static_cast<std::size_t>(std::max(f.degree_s(), degree_s)) + 1) {
  for (const DoubleBall& c : enclosed_coefficients<DoubleBall>(f, unit, degree_r, degree_s)) {
    middles_.push_back(c.approximation());
    errors_.push_back(c.radius());
  }
  for (std::size_t i = 0; i < errors_.size(); ++i) errors_[i] += relative_error() * std::fabs(middles_[i]);
}

/// Two more roundings, of the product and the sum. What the errors hold for later operations is for
/// |f| + |c g|.
PolynomialInBalls PolynomialInBalls::plus(double c, const PolynomialInBalls& g) const {
  PolynomialInBalls result = *this;
  for (std::size_t i = 0; i < middles_.size(); ++i) {
    const double product = c * g.middles_[i];
    result.middles_[i] += product;
    result.errors_[i] +=
        std::fabs(c) * g.errors_[i] + (std::fabs(middles_[i]) + std::fabs(product)) * (4 * kUnitRoundoff);
  }
  return result;
}

/// Of what the expansion takes: two operations for each step in either direction, and one for each sum.
double PolynomialInBalls::relative_error() const {
  return static_cast<double>(2 * (middles_.size() / row_ + row_)) * kUnitRoundoff;
}

DoubleBall PolynomialInBalls::over(const DoubleBall& u, const DoubleBall& v) const {
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
      g_u_(g.derivative_r(), greatest_coefficient(g), g.degree_r(), g.degree_s()),
      g_v_(g.derivative_s(), greatest_coefficient(g), g.degree_r(), g.degree_s()),
      y2_u_(chart.radicand.derivative_r(), 1),
      y2_v_(chart.radicand.derivative_s(), 1) {}

ChartRates ChartTangents::rates(const DoubleBall& u, const DoubleBall& v, double du, double dv) const {
  const bool is_steep = std::fabs(dv) > std::fabs(du);
  const PolynomialInBalls &above = is_steep ? g_v_ : g_u_, &below = is_steep ? g_u_ : g_v_;
  const double slope = is_steep ? du / dv : dv / du;
  const DoubleBall rate =  // (17.6c)
      DoubleBall(slope) - above.plus(slope, below).over(u, v) * reciprocal(below.over(u, v));
  ChartRates result{is_steep, is_steep ? rate : DoubleBall(1), is_steep ? DoubleBall(1) : rate, {}};
  if (!is_planar_) result.square = y2_u_.over(u, v) * result.u + y2_v_.over(u, v) * result.v;
  return result;
}

std::array<DoubleBall, 3> ChartTangents::over(const ChartRates& rates, const BallChart::Place& at,
                                              const BallChart& chart) const {
  if (is_planar_) return chart.tangent_along_axes({rates.u, rates.v, DoubleBall(0)}, at);
  const DoubleBall twice = at[2] + at[2];
  return chart.tangent_along_axes({twice * rates.u, twice * rates.v, rates.square}, at);
}

DoubleBall squares_between(const DoubleBall& from, const DoubleBall& to, const ChartRates& rates, double du,
                           double dv) {
  const double change = rates.square.upper_magnitude() * (rates.is_steep ? dv : du);
  return ((from + to) * DoubleBall(0.5)).widened(change / 2 * kSlack + kUnderflowLoss);
}

}  // namespace exsect
