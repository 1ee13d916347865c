// Points of a chart by rational intervals. Internal to solver/; docs/method-equations.md, section 17.6.
#pragma once

#include <exsect/algebra/ball.h>

#include <array>

#include "lift/surface_chart.h"

namespace exsect {

/// A place on a surface in space, or, along its three vectors, on a chart.
using SpaceBox = std::array<RationalInterval, 3>;

class ExactChart {
 public:
  using Interval = RationalInterval;
  using Place = std::array<RationalInterval, 3>;  // of u, v and y; or of the multiples of the vectors

  explicit ExactChart(const SurfaceChart& chart);

  /// y on a sheet over points of the surface in a rectangle.
  RationalInterval y_over(const RationalInterval& u, const RationalInterval& v, int sheet) const;
  /// The multiples of the chart's three vectors, from its origin, of points with u, v, y in these intervals.
  Place along_axes(const Place& at) const;
  /// For multiples of the vectors.
  SpaceBox in_space(const Place& along) const;

 private:
  const SurfaceChart& chart_;
  Polynomial radicand_in_u_, radicand_in_v_;  // it has no product of u and v
};

/// Nearest to the middle; the width, rounded; all of it.
double middle_of(const RationalInterval& at);
double width_of(const RationalInterval& at);
inline DoubleBall ball_of(const RationalInterval& at) { return DoubleBall::enclosing(at); }
/// Not below the distance of any of its numbers from x.
double distance_from(const RationalInterval& at, double x);

}  // namespace exsect
