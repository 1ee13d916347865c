// What is asked about a parameter line of one patch on the other patch, and the points that answer it.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/certified_point.h>

#include <optional>
#include <string>
#include <vector>

namespace exsect {

/// A closed interval of the line's parameter with algebraic ends (from == to: a single parameter).
struct AlgebraicInterval {
  RealAlgebraic from;
  RealAlgebraic to;
};

/// The line `fixed = value` (value in [0,1], else std::invalid_argument) of the patch that owns the
/// parameter, against the other patch.
struct LineQuery {
  Parameter fixed;
  Rational value;
};

/// The points alone. `points` are all isolated solutions in [0,1]^4, ascending in
/// the eliminant's variable, with pairwise disjoint boxes; `on_patch` the parameters of the line at the
/// solutions that are not isolated, as disjoint closed intervals: the parts of the line that lie on the other
/// patch, and single parameters at points to which a curve of the other patch's parameters is mapped.
struct LinePoints {
  std::vector<CertifiedPoint> points;
  std::vector<AlgebraicInterval> on_patch;
  /// Empty, or the reason why the list is not complete (never a silent omission).
  std::optional<std::string> incomplete;
};

}  // namespace exsect
