// Tangents of a lifted curve in balls. Internal to solver/; docs/method-equations.md, section 17.6.
#pragma once

#include <exsect/algebra/ball.h>

#include <array>
#include <vector>

#include "lift/ball_chart.h"

namespace exsect {

/// A polynomial in balls, divided by a number.
class EnclosedPolynomial {
 public:
  EnclosedPolynomial(const BivariatePolynomial& f, const Rational& unit);
  /// All values on a rectangle: Taylor's expansion about the middle, of the midpoints of the coefficients
  /// alone, with one bound of the errors (17.3a).
  DoubleBall over(const DoubleBall& u, const DoubleBall& v) const;

 private:
  double relative_error() const;

  std::size_t row_;
  std::vector<double> middles_;
  std::vector<double> errors_;
};

/// Of a curve g = 0 on a chart with y^2 = Y, at all places of a rectangle.
struct ChartDerivatives {
  DoubleBall g_u, g_v, y2_u, y2_v;

  /// Y_u g_v - Y_v g_u
  DoubleBall jacobian() const { return y2_u * g_v - y2_v * g_u; }
};

/// All Y of an arc of the curve in a rectangle with sides of at most these lengths, monotone in u and v, from
/// those of its ends (17.6b). Of infinite radius if the derivatives do not tell.
DoubleBall squares_between(const DoubleBall& from, const DoubleBall& to, const ChartDerivatives& at,
                           double du, double dv);

class ChartTangents {
 public:
  /// Of the curve g = 0 on the chart, on its plane of symmetry if it is planar.
  ChartTangents(const BivariatePolynomial& g, const SurfaceChart& chart, bool is_planar);
  ChartDerivatives derivatives(const DoubleBall& u, const DoubleBall& v) const;
  /// (17.6), by (17.14) along the chart's vectors: proportional to all tangents of the curve at places in
  /// these balls.
  std::array<DoubleBall, 3> over(const ChartDerivatives& derivatives, const BallChart::Place& at,
                                 const BallChart& chart) const;

 private:
  bool is_planar_;
  EnclosedPolynomial g_u_, g_v_, y2_u_, y2_v_;
};

}  // namespace exsect
