#include "line/exact_line_points.h"

#include <exsect/algebra/fixed_point_interval.h>
#include <exsect/algebra/resultant.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "answer/proof_failure.h"
#include "curve/plane_curve.h"
#include "curve/polynomial_vector.h"
#include "line/line_curve.h"
#include "line/line_forms.h"
#include "line/line_place.h"
#include "line/line_point.h"
#include "line/line_system.h"
#include "line/system_point.h"

namespace exsect {
namespace {

void append(std::vector<CertifiedPoint>& to, std::vector<CertifiedPoint> points) {
  std::ranges::move(points, std::back_inserter(to));
}

/// All points by the closed formula; empty optional where it does not decide: the eliminant vanishes
/// identically, or the line s = const through a root lies on the carrier. `problem` is asked where the
/// formula has no answer at a root.
template <class Problem>
std::optional<std::vector<CertifiedPoint>> points_by_formula(const LinePlace& place,
                                                             const IntegerLineAndPatch& integers,
                                                             const Problem& problem) {
  const auto forms = std::make_shared<const ConicForms>(conic_forms(integers));
  if (forms->eliminant.is_zero()) return std::nullopt;
  std::shared_ptr<const LineSystem> system;
  std::vector<CertifiedPoint> points;
  for (const RealAlgebraic& root : real_roots(forms->eliminant, 0, 1)) {
    // Narrow enough that an enclosure settles nearly every sign below.
    const RealAlgebraic s = root.refined_to(power_of_two(-32));
    if (sign_at(forms->s1, s) != 0) {
      append(points, conic_point(place, forms, s));
      continue;
    }
    if (!system) system = std::make_shared<const LineSystem>(line_system(problem()));
    const BivariatePolynomial common = gcd_at(system->first, system->second, s);
    if (common.is_zero()) return std::nullopt;
    if (common.degree_r() <= 0) continue;
    for (const TriangularPoint& at : roots_at(common, s, 0, 1))
      append(points, system_points(place, system, at, forms->eliminant, initial_width()));
  }
  return points;
}

std::vector<AlgebraicInterval> line_intervals(const LineSystem& system,
                                              const std::vector<AlgebraicInterval>& lambda) {
  std::vector<AlgebraicInterval> result;
  for (const MonotonePiece& piece : system.pieces)
    for (const AlgebraicInterval& interval : lambda) {
      const RealAlgebraic from = std::max(interval.from, RealAlgebraic(piece.lambda.lower));
      const RealAlgebraic to = std::min(interval.to, RealAlgebraic(piece.lambda.upper));
      if (to < from) continue;
      RealAlgebraic a = preimage(system.phi, piece, from);
      RealAlgebraic b = preimage(system.phi, piece, to);
      if (b < a) std::swap(a, b);
      result.push_back({std::move(a), std::move(b)});
    }
  return merged(std::move(result));
}

/// Refines until f, not zero at the point, has no zero over the box.
void keep_off(CertifiedPoint& point, const LineRoles& roles, const BivariatePolynomial& f) {
  Rational width = initial_width();
  for (long bits = 64;; bits *= 2, width *= width) {
    const FixedPointInterval r(point.box()[index(roles.first)], bits);
    const FixedPointInterval s(point.box()[index(roles.second)], bits);
    if (!enclose(f, r, s).contains_zero()) return;
    point = point.refined_to(width);
  }
}

/// An isolated solution (r,s) of the system.
struct Solution {
  TriangularPoint at;
  bool on_curve;  // where the shared factor vanishes
  Rational width;
};

/// Every case, through the common factor of the two equations.
LinePoints points_by_system(const LinePlace& place, const LineAndPatch& problem) {
  const auto system = std::make_shared<const LineSystem>(line_system(problem));
  const BivariatePolynomial shared = gcd(system->first, system->second);
  CurveOnLine curve;
  std::vector<Solution> solutions;
  Polynomial eliminant;
  if (shared.is_zero()) {
    curve = square_on_line(system->lambda, lambda_range(*system));
  } else {
    if (shared.degree_r() > 0 || shared.degree_s() > 0)
      curve = curve_on_line(shared, system->lambda, lambda_range(*system));
    const BivariatePolynomial first = exact_quotient(system->first, shared);
    const BivariatePolynomial second = exact_quotient(system->second, shared);
    for (const TriangularPoint& at : common_points(first, second))
      if (sign_at(shared, at) != 0) solutions.push_back({at, false, initial_width()});
    if (!solutions.empty()) eliminant = resultant_r(first, second);
  }
  for (const IsolatedPoint& p : curve.isolated)
    solutions.push_back({p.at, true, std::min(initial_width(), p.distance)});
  std::ranges::stable_sort(solutions,
                           [](const Solution& a, const Solution& b) { return a.at.s() < b.at.s(); });
  LinePoints result;
  for (const Solution& p : solutions) {
    std::vector<CertifiedPoint> points =
        system_points(place, system, p.at, p.on_curve ? Polynomial() : eliminant, p.width);
    if (!p.on_curve)
      for (CertifiedPoint& point : points) keep_off(point, place.roles, shared);
    append(result.points, std::move(points));
  }
  result.on_patch = line_intervals(*system, curve.lambda);
  return result;
}

/// A line that is one point: every t, if the point lies on the patch.
LinePoints points_of_collapsed_line(const LineAndPatch& problem) {
  const PolynomialVector equations = coordinates_from(problem.patch, problem.line.a[0]);
  LinePoints result;
  if (have_common_zero({equations.begin(), equations.end()}))
    result.on_patch.push_back({RealAlgebraic(0), RealAlgebraic(1)});
  return result;
}

LinePoints points_on_line(const BezierPatch& x, const BezierPatch& y, const LineQuery& query) {
  const LinePlace place = line_place(query);
  const auto problem = [&] { return line_and_patch(x, y, query); };
  const IntegerLineAndPatch integers = integer_line_and_patch(x, y, query);
  if (is_conic(integers.line))
    if (auto points = points_by_formula(place, integers, problem)) {
      separate(*points);
      return {std::move(*points), {}, std::nullopt};
    }
  const LineAndPatch general = problem();
  if (shape(general.line) == LineShape::point) return points_of_collapsed_line(general);
  LinePoints result = points_by_system(place, general);
  separate(result.points);
  return result;
}

}  // namespace

LinePoints exact_line_points(const BezierPatch& x, const BezierPatch& y, const LineQuery& query) {
  LinePoints result;
  if (auto why = failure_of([&] { result = points_on_line(x, y, query); }))
    result.incomplete = std::move(why);
  return result;
}

}  // namespace exsect
