#include "line/rational_line_intersection.h"

#include <exsect/algebra/resultant.h>
#include <exsect/solver/rational_line_points.h>

#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "answer/proof_failure.h"
#include "line/line_carrier.h"
#include "line/line_place.h"
#include "line/line_point.h"
#include "line/line_point_source.h"
#include "line/rational_line.h"

namespace exsect {
namespace {

/// t on the line, r and s on the patch, each as an algebraic number.
class RationalPointSource : public LinePointSource {
 public:
  RationalPointSource(LinePlace place, LocalSides sides, RationalLinePoint point)
      : LinePointSource(std::move(place), sides), point_(std::move(point)) {}

 protected:
  LocalBox local_box(const Rational& width) const override {
    const TriangularPoint fine = point_.parameters.refined_to(width);
    return {point_.t.enclosure(width), fine.r_interval(), fine.s().interval()};
  }

 private:
  RationalLinePoint point_;
};

std::optional<int> side_of_first(const TriangularPoint& at) {
  for (const int side : {0, 1})
    if (sign_at(BivariatePolynomial::r() - BivariatePolynomial::constant(side), at) == 0) return side;
  return std::nullopt;
}

/// The eliminant and the first of two equations say what they say of biquadratic patches.
CertifiedPoint certified_point(const LinePlace& place, const RationalLinePoint& point,
                               const LineIntersection& line) {
  const LocalSides sides = {point.t.compare(0) == 0   ? std::optional(0)
                            : point.t.compare(1) == 0 ? std::optional(1)
                                                      : std::nullopt,
                            side_of_first(point.parameters), side_of(point.parameters.s())};
  const int multiplicity = point.is_transversal ? 1
                           : line.eliminant.is_zero()
                               ? 0
                               : root_multiplicity(line.eliminant, point.parameters.s());
  const int degree = line.pullback.plane.degree_r();
  const int branch =
      degree < 1 || degree > 2
          ? 0
          : branch_from(sign_at(line.pullback.plane.derivative_r(), point.parameters), degree == 1);
  return {std::make_shared<RationalPointSource>(place, sides, point), initial_width(),
          global_sides(place, sides), multiplicity, branch};
}

LinePoints certified_points(const LinePlace& place, RationalLinePoints&& exact,
                            const LineIntersection& line) {
  LinePoints result{{}, std::move(exact.on_patch), std::move(exact.incomplete)};
  for (const RationalLinePoint& point : exact.points)
    result.points.push_back(certified_point(place, point, line));
  separate(result.points);
  return result;
}

Point point_at(const HomogeneousCurve& curve, const Rational& t) {
  const Rational weight = curve[3](t);
  return {curve[0](t) / weight, curve[1](t) / weight, curve[2](t) / weight};
}

/// Two orthogonal planes; and where the line runs through its segment once, the segment by the coordinate
/// that changes along it.
void describe_rational_segment(LineIntersection& result, const RationalLine& line) {
  const std::vector<MovingPlane> planes = moving_planes(line.curve, 0);
  const auto normal = [&](std::size_t i) { return Point{planes[i][0][0], planes[i][0][1], planes[i][0][2]}; };
  const Point start = point_at(line.curve, 0), end = point_at(line.curve, 1);
  result.plane = form_through(start, normal(0));
  result.second = form_through(start, cross(cross(normal(0), normal(1)), normal(0)));
  result.pullback.plane = pull_back(result.plane, line.patch);
  result.pullback.m = pull_back(*result.second, line.patch);
  if (result.shape == LineShape::folded) return;
  std::size_t k = 0;
  while (start[k] == end[k]) ++k;
  const BivariatePolynomial denominator = line.patch.component(3);
  result.pullback.u = denominator * Polynomial(Rational(end[k] - start[k]));
  result.pullback.l = line.patch.component(static_cast<int>(k)) - denominator * Polynomial(start[k]);
}

void describe_rational_conic(LineIntersection& result, const RationalLine& line) {
  std::array<HomogeneousPoint, 3> a;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 4; ++k) a[i][k] = line.curve[k].coefficient(static_cast<int>(i));
  result.forms = axis_forms(a);
  result.plane = result.forms->plane;
  result.pullback = pull_back(*result.forms, line.patch);
}

bool divides(const BivariatePolynomial& f, const BivariatePolynomial& g) {
  if (f.is_zero()) return g.is_zero();
  const BivariatePolynomial common = gcd(f, g);
  return common.degree_r() == f.degree_r() && common.degree_s() == f.degree_s();
}

/// Of the equations of a plane cubic, most say no more than that a point is on the plane.
void describe_cubic(LineIntersection& result, const RationalLine& line) {
  const LineCarrier carrier(line.curve, components_of(line.patch));
  if (result.shape == LineShape::twisted_cubic) {
    result.cubic = carrier.equations();
    return;
  }
  const std::array<Rational, 4>& plane = carrier.fixed_planes()[0][0];
  result.plane = {{plane[0], plane[1], plane[2]}, plane[3]};
  result.pullback.plane = pull_back(result.plane, line.patch);
  for (const BivariatePolynomial& f : carrier.equations())
    if (!divides(result.pullback.plane, f)) result.cubic = {f};
}

Polynomial eliminant_of(const LineIntersection& line) {
  const PullBack& p = line.pullback;
  if (line.shape != LineShape::conic && !line.second) return {};
  const Polynomial f = resultant_r(p.plane, line.forms ? p.cylinder() : p.m);
  return f.leading_coefficient() < 0 ? (-f).primitive() : f.primitive();
}

void describe(LineIntersection& result, const RationalLine& line) {
  switch (result.shape) {
    case LineShape::point:
      return;
    case LineShape::straight:
    case LineShape::folded:
      return describe_rational_segment(result, line);
    case LineShape::conic:
      return describe_rational_conic(result, line);
    case LineShape::plane_cubic:
    case LineShape::twisted_cubic:
      return describe_cubic(result, line);
  }
}

}  // namespace

LineIntersection rational_line_intersection(const RationalPatch& x, const RationalPatch& y,
                                            const LineQuery& query) {
  const LinePlace place = line_place(query);
  const RationalLine line = rational_line(x, y, query);
  LineIntersection result;
  result.query = query;
  result.shape = shape(line.curve);
  result.eliminant_variable = place.roles.second;
  const auto why = failure_of([&] {
    describe(result, line);
    result.eliminant = eliminant_of(result);
    const PullBack& p = result.pullback;
    if (!p.u.is_zero() && !p.plane.is_zero() && p.plane.degree_r() <= 2)
      result.feasible = feasible_intervals(p);
    result.solution = certified_points(place, rational_line_points(x, y, query), result);
  });
  if (why) result.solution = {{}, {}, why};
  return result;
}

}  // namespace exsect
