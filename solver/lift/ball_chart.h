// Points of a chart by balls in doubles: ExactChart, where doubles suffice. Internal to solver/;
// docs/method-equations.md, section 17.6.
#pragma once

#include <exsect/algebra/ball.h>

#include <array>

#include "lift/surface_chart.h"

namespace exsect {

/// A polynomial of degree at most 2.
class QuadraticInBalls {
 public:
  explicit QuadraticInBalls(const Polynomial& f);
  /// All values on the ball.
  DoubleBall over(const DoubleBall& u) const;

 private:
  std::array<DoubleBall, 3> c_;
};

/// All 1/b; of infinite radius where b may be 0.
DoubleBall reciprocal(const DoubleBall& b);

class BallChart {
 public:
  using Interval = DoubleBall;
  using Place = std::array<DoubleBall, 3>;  // as of ExactChart

  explicit BallChart(const SurfaceChart& chart);

  /// Values beyond doubles, and quotients by what may be 0, are balls about which nothing is proved.
  DoubleBall y_over(const DoubleBall& u, const DoubleBall& v, int sheet) const;
  /// y^2, and y of this sign for the numbers of a ball that are not negative.
  DoubleBall square_over(const DoubleBall& u, const DoubleBall& v) const;
  static DoubleBall y_of(const DoubleBall& square, int sheet);
  Place along_axes(const Place& at) const;
  std::array<DoubleBall, 3> in_space(const Place& along) const;
  /// (17.14): the image along the vectors of a tangent (t_u, t_v, t_y) in a point with u, v, y in these
  /// balls.
  Place tangent_along_axes(const Place& tangent, const Place& at) const;

 private:
  bool is_affine_;
  std::array<DoubleBall, 3> origin_;
  std::array<std::array<DoubleBall, 3>, 3> vectors_;
  QuadraticInBalls radicand_in_u_, radicand_in_v_;
  QuadraticInBalls height_, width_, denominator_, height_rate_, width_rate_;
  DoubleBall middle_;
};

inline double middle_of(const DoubleBall& at) { return at.approximation(); }
inline double width_of(const DoubleBall& at) { return 2 * at.radius(); }
inline DoubleBall ball_of(const DoubleBall& at) { return at; }
inline double distance_from(const DoubleBall& at, double x) { return (at - DoubleBall(x)).upper_magnitude(); }

}  // namespace exsect
