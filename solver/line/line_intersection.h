// A parameter line of one patch against the other patch: eliminant, feasible intervals, certified points.
#pragma once

#include <exsect/geometry/parameter_line.h>
#include <exsect/geometry/pull_back.h>
#include <exsect/solver/feasible_intervals.h>
#include <exsect/solver/line_query.h>

#include <optional>
#include <vector>

namespace exsect {

/// Everything about one line, as shown by `exsect line`.
struct LineIntersection {
  LineQuery query;
  LineShape shape;
  AffineForm plane;  // conic: the line's plane; straight: the first of two orthogonal planes; point: 0
  std::optional<AffineForm> second;  // straight or folded: the second plane
  std::optional<LineForms> forms;    // conic: the orthogonal cylinder
  /// On the other patch; zero for a point. Straight: first plane, and the second one as m; 0 <= l/u <= 1 is
  /// the segment.
  PullBack pullback;
  Parameter eliminant_variable;  // s for a line of x, v for a line of y
  /// Degree 16, or 8 for a straight line, in general; primitive, positive leading coefficient. Zero if the
  /// carrier of the line (parabola or straight line) and the patch share a curve other than a line where the
  /// variable is constant, and for a point.
  Polynomial eliminant;
  std::vector<FeasibleBranch> feasible;  // empty where the pulled-back plane is zero
  LinePoints solution;
};
LineIntersection intersect_line(const BezierPatch& x, const BezierPatch& y, const LineQuery& query);

}  // namespace exsect
