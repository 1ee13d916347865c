#include "lift/chart_tangents.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>

#include "curve/taylor_shift.h"

namespace exsect {

EnclosedPolynomial::EnclosedPolynomial(const BivariatePolynomial& f, const Rational& unit)
    : row_(static_cast<std::size_t>(std::max(f.degree_s(), 0)) + 1),
      c_(enclosed_coefficients<DoubleBall>(f, unit)) {}

DoubleBall EnclosedPolynomial::over(const DoubleBall& u, const DoubleBall& v) const {
  std::vector<DoubleBall> c = c_;
  shift_to(c, row_, u.midpoint(), v.midpoint());
  double others = 0, power_u = 1;
  for (std::size_t i = 0; i < c.size(); i += row_, power_u *= u.radius()) {
    double power = power_u;
    for (std::size_t j = 0; j < row_; ++j, power *= v.radius())
      if (i + j > 0) others += c[i + j].upper_magnitude() * power;
  }
  return c[0].widened(others * kSlack + kUnderflowLoss);
}

ChartTangents::ChartTangents(const BivariatePolynomial& g, const SurfaceChart& chart, bool is_planar)
    : is_planar_(is_planar),
      g_u_(g.derivative_r(), greatest_coefficient(g)),
      g_v_(g.derivative_s(), greatest_coefficient(g)),
      y2_u_(chart.radicand.derivative_r(), 1),
      y2_v_(chart.radicand.derivative_s(), 1) {}

std::array<DoubleBall, 3> ChartTangents::over(const BallChart::Place& at, const BallChart& chart) const {
  const auto& [u, v, y] = at;
  const DoubleBall a = g_u_.over(u, v), b = g_v_.over(u, v);
  if (is_planar_) return chart.tangent_along_axes({b, -a, DoubleBall(0)}, at);
  const DoubleBall twice = y + y;
  return chart.tangent_along_axes({twice * b, -(twice * a), y2_u_.over(u, v) * b - y2_v_.over(u, v) * a}, at);
}

}  // namespace exsect
