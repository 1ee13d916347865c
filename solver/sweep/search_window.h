// A search over a slab of the domain. Internal to solver/.
#pragma once

#include "sweep/sweep_data.h"
#include "trace/subdivision.h"

namespace exsect {

/// All points over values of one parameter in an interval. The search sees it as [0,1].
struct SearchWindow {
  Parameter across;
  RationalInterval range;

  ParameterBox box(const SearchRegion& seen) const;
  template <class Ball>
  BallPoint<Ball> point(BallPoint<Ball> seen) const {
    Ball& t = seen[index(across)];
    t = Ball::enclosing(range.lower) + Ball::enclosing(range.width()) * t;
    return seen;
  }
  /// c.T is the same linear form as without the window: beside a curve along the slab its small factor keeps
  /// a component of T small that the window enlarges.
  std::array<double, 2> direction(std::array<double, 2> c) const;
};

/// Around a value of the swept parameter, and thin beside what is over other values: other turning points and
/// points on sides are far away, as the search sees it.
SearchWindow window_around(const SweepData& sweep, const RealAlgebraic& value);

SearchRegion rounded_outwards(const ParameterBox& box);

}  // namespace exsect
