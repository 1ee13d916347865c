// All branches of the solutions near a common corner, by charts with integer weights. Internal to solver/;
// docs/method-doubles.md, section 14.26.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "filter/corner_chart.h"

namespace exsect::filter {

/// A branch in the chart p = t^p_weight, q = c t^q_weight of an edge: for each t > 0 with p <= reach and
/// c.lower t^q_weight <= reach one solution has c in the interval, and c is inside of it. All parameters,
/// counted from the corner, are positive there.
struct CornerBranch {
  PolygonEdge edge;
  RationalInterval c;
};

/// All solutions in the box [0,reach]^4, counted from the corner, are the corner, the common sides, and these
/// branches.
struct CornerBranches {
  CornerEquation equation;
  Rational reach;  // 2^-k
  long k;
  std::vector<CornerBranch> branches;
};

/// Empty if that is not proved for any reach of some. Common sides end in the corner.
std::optional<CornerBranches> corner_branches(const CornerNet& x, const CornerNet& y,
                                              const std::vector<SideAtCorner>& sides = {});

}  // namespace exsect::filter
