// Feasible intervals of the branches r_1(s), r_2(s) of the pulled-back plane.
#pragma once

#include <vector>

#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/pull_back.h>

namespace exsect {

/// Ends in [0,1]; each open or closed. from == to with both closed is an isolated single point.
struct FeasibleInterval {
  RealAlgebraic from;
  RealAlgebraic to;
  bool from_closed;
  bool to_closed;
};

/// The s in [0,1] where branch i (9.16) is real with 0 <= r_i(s) <= 1 and 0 <= t <= 1 on the line: ordered, disjoint,
/// maximal.
struct FeasibleBranch {
  int branch;  // 1: (-B - sqrt D)/(2A), 2: (-B + sqrt D)/(2A); where A vanishes the finite one continues
  std::vector<FeasibleInterval> intervals;
};

/// Both branches. Requires a pull-back of bidegree at most (2,2) whose plane is not identically zero, else
/// std::domain_error.
std::vector<FeasibleBranch> feasible_intervals(const PullBack& pullback);

}  // namespace exsect
