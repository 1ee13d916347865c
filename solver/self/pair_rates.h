// How a pair of parameters moves along a curve in a chart. Internal to solver/.
#pragma once

#include "self/chart.h"

namespace exsect {

// Half width of a tube for each unit of its length, so that enclosures of its points fit in.
inline constexpr double kChartTubeRoom = 0x1p-8;

/// The kernel of DH at a point, a continuous field on a chart.
template <class Ball>
BallPoint<Ball> tangent_at(const ChartSystem<Ball>& system, const BallPoint<Ball>& p) {
  const ChartNet<Ball, 2> taylor = system.taylor(p);
  std::array<BallVector<Ball>, 4> column;
  for (std::size_t j = 0; j < 4; ++j) {
    column[j] = taylor[chart_strides(2)[j]];
  }
  const BallVector<Ball> last = cross(column[2], column[3]);
  const BallVector<Ball> first = cross(column[0], column[1]);
  return {dot(column[1], last), -dot(column[0], last), dot(first, column[3]), -dot(first, column[2])};
}

/// 2 t times the derivatives of u1, v1, u2, v2 (for t > 0), (7.7), for the derivative d of (U,V,m,w) at p.
template <class Ball>
BallPoint<Ball> pair_rates(Chart chart, const BallPoint<Ball>& p, const BallPoint<Ball>& d) {
  const Ball t2 = Ball(2) * square_root(p[3]);
  const Ball u = t2 * d[0];
  const Ball v = t2 * d[1];
  const Ball dv = p[2] * d[3] + Ball(2) * p[3] * d[2];
  return chart == Chart::first ? BallPoint<Ball>{u + d[3], v + dv, u - d[3], v - dv}
                               : BallPoint<Ball>{v + dv, u + d[3], v - dv, u - d[3]};
}

}  // namespace exsect
