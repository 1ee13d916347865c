// Feasible intervals of the branches r_1(s), r_2(s) of the pulled-back plane.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/pull_back.h>

#include <vector>

namespace exsect {

/// Ends in [0,1]; each open or closed. from == to with both closed is an isolated single point.
struct FeasibleInterval {
  RealAlgebraic from;
  RealAlgebraic to;
  bool from_closed;
  bool to_closed;
};

/// The s in [0,1] where branch i (9.16) of P = A r^2 + B r + C is real with 0 <= r_i(s) <= 1 and 0 <= t <= 1
/// on the line, t = L/U (2.2): ordered, disjoint, maximal. Where A(s) = 0 the finite root -C/B continues the
/// branch it is the limit of (2 if B > 0, 1 if B < 0) and the other one is infinite: not feasible. Where A =
/// B = C = 0 every r solves P = 0: such an s belongs to all branches if some r in [0,1] has 0 <= t <= 1.
struct FeasibleBranch {
  int branch;  // 1: (-B - sqrt D)/(2A), 2: (-B + sqrt D)/(2A)
  std::vector<FeasibleInterval> intervals;
};

/// Both branches; only branch 1, the root -C/B, if A vanishes identically. Requires a plane of degree at most
/// 2 in r that is not identically zero, else std::domain_error.
std::vector<FeasibleBranch> feasible_intervals(const PullBack& pullback);

}  // namespace exsect
