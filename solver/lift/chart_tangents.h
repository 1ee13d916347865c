// Tangents of a lifted curve in balls. Internal to solver/; docs/method-equations.md, section 17.6.
#pragma once

#include <exsect/algebra/ball.h>

#include <array>
#include <vector>

#include "lift/ball_chart.h"

namespace exsect {

/// A polynomial in balls, divided by a number.
class PolynomialInBalls {
 public:
  /// As one of at least these degrees.
  PolynomialInBalls(const BivariatePolynomial& f, const Rational& unit, int degree_r = 0, int degree_s = 0);
  /// f + c g, for one of the same degrees.
  PolynomialInBalls plus(double c, const PolynomialInBalls& g) const;
  /// All values on a rectangle: Taylor's expansion about the middle, of the midpoints of the coefficients
  /// alone, with one bound of the errors (17.3a).
  DoubleBall over(const DoubleBall& u, const DoubleBall& v) const;

 private:
  double relative_error() const;

  std::size_t row_;
  std::vector<double> middles_;
  std::vector<double> errors_;
};

/// Of a curve g = 0 on a chart with y^2 = Y, at all places of a rectangle: the changes of u, v and Y along
/// the curve for each unit of u, or of v if it is steep.
struct ChartRates {
  bool is_steep;
  DoubleBall u, v, square;
};

/// All Y of an arc of the curve in a rectangle with sides of at most these lengths, monotone in u and v, from
/// those of its ends (17.6b). Nothing is proved about it if the rates are not known.
DoubleBall squares_between(const DoubleBall& from, const DoubleBall& to, const ChartRates& rates, double du,
                           double dv);

class ChartTangents {
 public:
  /// Of the curve g = 0 on the chart, on its plane of symmetry if it is planar.
  ChartTangents(const BivariatePolynomial& g, const SurfaceChart& chart, bool is_planar);
  /// On a rectangle, for an arc that changes by about (du, dv) there (17.6c).
  ChartRates rates(const DoubleBall& u, const DoubleBall& v, double du, double dv) const;
  /// (17.6), by (17.14) along the chart's vectors: proportional to all tangents of the curve at places in
  /// these balls.
  std::array<DoubleBall, 3> over(const ChartRates& rates, const BallChart::Place& at,
                                 const BallChart& chart) const;

 private:
  bool is_planar_;
  PolynomialInBalls g_u_, g_v_, y2_u_, y2_v_;
};

}  // namespace exsect
