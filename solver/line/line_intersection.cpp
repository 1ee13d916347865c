#include "line/line_intersection.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/resultant.h>
#include <exsect/geometry/straight_line.h>

#include "line/exact_line_points.h"
#include "line/line_forms.h"
#include "line/line_system.h"
#include "line/rational_line_intersection.h"

namespace exsect {
namespace {

Polynomial primitive_positive(const Polynomial& f) {
  return f.leading_coefficient() < 0 ? (-f).primitive() : f.primitive();
}

Polynomial eliminant(const IntegerLineAndPatch& problem, const LineSystem& system) {
  if (is_conic(problem.line)) {
    // Where A vanishes identically the formal degree 2 would bring in a factor that has no meaning.
    const ConicForms forms = conic_forms(problem);
    if (!forms.a.is_zero() && !forms.eliminant.is_zero()) return primitive_positive(forms.eliminant);
  }
  return primitive_positive(resultant_r(system.first, system.second));
}

void describe_conic(LineIntersection& result, const LineAndPatch& problem) {
  result.forms = orthogonal_forms(problem.line);
  result.plane = result.forms->plane;
  result.pullback = pull_back(*result.forms, problem.patch);
}

/// 0 <= l/u <= 1 exactly where lambda is in the range of the segment.
void describe_straight(LineIntersection& result, const LineAndPatch& problem, const LineSystem& system) {
  const StraightForms forms = straight_forms(problem.line);
  result.plane = forms.first;
  result.second = forms.second;
  const RationalInterval range = lambda_range(system);
  result.pullback = {system.first, BivariatePolynomial::constant(range.width()),
                     system.lambda - BivariatePolynomial::constant(range.lower), system.second};
}

}  // namespace

LineIntersection intersect_line(const BezierPatch& x, const BezierPatch& y, const LineQuery& query) {
  return in_nearest_rounding([&]() -> LineIntersection {
    const LineAndPatch problem = line_and_patch(x, y, query);
    LineIntersection result;
    result.query = query;
    result.shape = shape(problem.line);
    result.eliminant_variable = line_place(query).roles.second;
    result.solution = exact_line_points(x, y, query);
    if (result.shape == LineShape::point) return result;
    const LineSystem system = line_system(problem);
    if (result.shape == LineShape::conic)
      describe_conic(result, problem);
    else
      describe_straight(result, problem, system);
    result.eliminant = eliminant(integer_line_and_patch(x, y, query), system);
    if (!result.pullback.plane.is_zero()) result.feasible = feasible_intervals(result.pullback);
    return result;
  });
}

LineIntersection intersect_line(const RationalPatch& x, const RationalPatch& y, const LineQuery& query) {
  const std::optional<BezierPatch> first = x.biquadratic(), second = y.biquadratic();
  if (first && second) return intersect_line(*first, *second, query);
  return in_nearest_rounding([&] { return rational_line_intersection(x, y, query); });
}

}  // namespace exsect
