// The one-dimensional part of the solutions when a line, or a piece of it, lies on the patch.
#pragma once

#include <exsect/algebra/triangular_point.h>
#include <exsect/solver/line_query.h>

#include <vector>

namespace exsect {

/// Ascending, each once.
void sort_unique(std::vector<RealAlgebraic>& values);
/// A rational between neighbours a < b.
Rational sample_between(RealAlgebraic a, RealAlgebraic b);

/// An isolated point of a set S in the (r,s) square. S has no other point within `distance` of it in both
/// parameters.
struct IsolatedPoint {
  TriangularPoint at;
  Rational distance;
};

/// S: the (r,s) in [0,1]^2 on a curve with lambda(r,s) in a closed range.
struct CurveOnLine {
  std::vector<AlgebraicInterval>
      lambda;  // lambda of the points of S that are not isolated: disjoint, ascending
  std::vector<IsolatedPoint> isolated;
};

/// S for the curve f = 0; f not zero, else std::domain_error.
CurveOnLine curve_on_line(const BivariatePolynomial& f, const BivariatePolynomial& lambda,
                          const RationalInterval& range);
/// S for the whole square.
CurveOnLine square_on_line(const BivariatePolynomial& lambda, const RationalInterval& range);

/// The union of closed intervals as disjoint ones, ascending.
std::vector<AlgebraicInterval> merged(std::vector<AlgebraicInterval> intervals);

}  // namespace exsect
