// The points of a parameter line of one patch of any kind on another one, exact. docs/method.md, section 3.
#pragma once

#include <exsect/algebra/triangular_point.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/line_parameter.h>
#include <exsect/solver/line_query.h>

#include <optional>
#include <string>
#include <vector>

namespace exsect {

/// The point at t on the line.
struct RationalLinePoint {
  LineParameter t;
  /// On the other patch, r and s its first and second parameter.
  TriangularPoint parameters;
  /// Line and patch cross: there the tangents of the line's carrier and of the patch span space.
  bool is_transversal;
};

/// `points` are the solutions, ascending in the second parameter of the other patch, beside the curves of the
/// other patch's parameters all of which are mapped to the carrier of the line; `on_patch` the t at these
/// curves, disjoint closed intervals in ascending order.
struct RationalLinePoints {
  std::vector<RationalLinePoint> points;
  std::vector<AlgebraicInterval> on_patch;
  /// Empty, or the reason why the list is not complete.
  std::optional<std::string> incomplete;
};

/// The line `fixed = value` of the patch that owns the parameter, against the other patch, both of any
/// bidegree and with weights or without. Throws std::invalid_argument for a value outside [0,1]. Incomplete
/// where all of the other patch is a piece of the line's carrier, and in the rare case of quotient_at
/// (algebra/algebraic_value.h).
RationalLinePoints rational_line_points(const RationalPatch& x, const RationalPatch& y,
                                        const LineQuery& query);

}  // namespace exsect
