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
  /// Plane curve: the line's plane; straight: the first of two orthogonal planes; point, twisted cubic: 0.
  AffineForm plane;
  std::optional<AffineForm> second;  // straight or folded: the second plane
  std::optional<LineForms> forms;  // conic: the orthogonal cylinder, with weights one along a coordinate axis
  /// On the other patch, times its denominator; zero for a point. Straight: first plane, and the second one
  /// as m; 0 <= l/u <= 1 is the segment. Plane cubic: the plane alone.
  PullBack pullback;
  /// Of a cubic, on the other patch as above: all vanish at the points of its carrier, and where the plane
  /// vanishes too only there. Of a plane cubic one equation, of a twisted cubic three.
  std::vector<BivariatePolynomial> cubic;
  Parameter eliminant_variable;  // s for a line of x, v for a line of y
  /// Res_r of the plane and the cylinder or the second plane: degree 2 e mn for a patch of bidegree (m,n) and
  /// a line of degree e <= 2, without weights and in general 16 or 8 of biquadratic patches; primitive,
  /// positive leading coefficient. Zero if the carrier of the line (conic or straight line) and the patch
  /// share a curve other than a line where the variable is constant, for a point and for a cubic.
  Polynomial eliminant;
  /// Empty where the pulled-back plane is zero or of degree 3 in r, and of a cubic; of a folded line with
  /// weights or of degree 3 too.
  std::vector<FeasibleBranch> feasible;
  LinePoints solution;
};

/// Throws std::invalid_argument for a value outside [0,1], as the next one.
LineIntersection intersect_line(const BezierPatch& x, const BezierPatch& y, const LineQuery& query);
/// The same of patches of any bidegree to (3,3), with weights or without (docs/method.md, section 3); the
/// same result, where both are polynomial of true bidegree at most (2,2). The multiplicity of a point of a
/// cubic that is not transversal is 0, and its branch 0 where the plane has degree 3 in r.
LineIntersection intersect_line(const RationalPatch& x, const RationalPatch& y, const LineQuery& query);

}  // namespace exsect
