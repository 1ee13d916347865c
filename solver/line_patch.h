// A parameter line of one patch against the other patch: eliminant, feasible intervals, certified points.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/parameter_line.h>
#include <exsect/geometry/pull_back.h>
#include <exsect/solver/certified_point.h>
#include <exsect/solver/feasible_intervals.h>

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
/// By the eliminant of the line, in balls of two doubles where they decide every sign (docs/method.md,
/// section 9), over the integers where not.
LinePoints line_points(const BezierPatch& x, const BezierPatch& y, const LineQuery& query);

/// The same points, decided in doubles with proved errors where they suffice (docs/method.md, section 14.3)
/// and by line_points where not. Boxes are as narrow as doubles allow; refinement and branches go back to
/// line_points.
LinePoints line_points_filtered(const BezierPatch& x, const BezierPatch& y, const LineQuery& query);

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
