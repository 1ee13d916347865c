// A chart with integer weights near a common corner, on an edge of Newton's polygon. Internal to solver/;
// docs/method-doubles.md, section 14.26.
#pragma once

#include "filter/corner_equation.h"
#include "filter/newton_polygon.h"

namespace exsect::filter {

/// The p = t^p_weight, q = c t^q_weight with c in the interval, t > 0, p <= 2^-k and c.lower t^q_weight <=
/// 2^-k; c.lower > 0, k > 0. Refers to the edge.
struct CornerChart {
  const PolygonEdge& edge;
  RationalInterval c;
  long k;
};

/// g, of whose polygon the edge is one, has no zero in the chart, as parts of it show.
bool is_empty(const PlaneSeries& g, const CornerChart& chart);
/// (14.125): g has one zero for each t, and it is inside of the interval of c. Requires c.upper <= 7/4
/// c.lower and that the reach of g is 2 2^-k at least.
bool is_one_branch(const PlaneSeries& g, const CornerChart& chart);
/// The sign of f in all of the chart; 0 if that is not proved.
int sign_in(const PlaneSeries& f, const CornerChart& chart);
/// (14.126): all parameters increase along the zeros with t, as long as 2 t is in the chart. Requires
/// is_one_branch(), and sign_in() = 1 of the bound parameters.
bool all_increase(const CornerEquation& equation, const CornerChart& chart);

/// floor(n / d); requires n >= 0, d > 0.
inline long floor_of(long n, long d) { return n / d; }

}  // namespace exsect::filter
