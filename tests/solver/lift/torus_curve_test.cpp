// Curves on tori by charts, against the same curves found otherwise: in the charts of the other torus, or
// over the shadow on a quadric.
#include "lift/torus_curve.h"

#include <exsect/geometry/surface_pull_back.h>
#include <exsect/solver/intersect_equations.h>

#include <cmath>
#include <map>
#include <string>

#include "support/catch.h"

namespace exsect::torus_curve_test {
namespace {

using S = ImplicitSurface;
const Point origin = {0, 0, 0}, up = {0, 0, 1}, right = {1, 0, 0};
const SpacePolynomial z = SpacePolynomial::variable(2);

Rational tenth_to(int k) { return k == 0 ? Rational(1) : tenth_to(k - 1) / 10; }

S by_equation(const S& surface) { return S::polynomial(surface.equation()); }

IntersectOptions within(double tolerance) {
  IntersectOptions options;
  options.tolerance = tolerance;
  return options;
}

/// Curves, without their names, by multiplicity; special nodes.
std::map<std::string, int> shape(const S& first, const S& second) {
  const SurfaceIntersection result = intersect(first, second, within(1e-2));
  std::map<std::string, int> counts;
  counts[result.status != Status::complete ? "incomplete" : result.is_same ? "same" : "complete"] = 1;
  for (const SpaceCurve& curve : result.curves) {
    CHECK(curve.is_closed);
    ++counts["closed " + std::to_string(curve.multiplicity)];
  }
  for (const SpaceNode& node : result.nodes)
    if (node.kind != SpaceNodeKind::joint) ++counts[name(node.kind)];
  return counts;
}
using Shape = std::map<std::string, int>;

}  // namespace

TEST_CASE("torus charts: four patches of the torus, with common sides") {
  for (const S& torus : {S::torus({1, 2, 3}, {2, -2, 1}, Rational(5, 2), Rational(2, 3)),
                         S::torus(origin, {0, 0, -2}, 3, 1)}) {
    const TorusFrame frame = torus_frame(*torus.data()).value();
    const TorusTurns turns = {turn_by(Rational(1, 3)), turn_by(Rational(1, 5))};
    const SpacePolynomial f = z * z * z - SpacePolynomial::variable(0) * SpacePolynomial::variable(1);
    const BivariatePolynomial first = pull_back(f, torus_chart(frame, turns, 0, 0));
    for (const int i : {0, 1})
      for (const int j : {0, 1}) {
        const RationalPatch patch = torus_chart(frame, turns, i, j);
        CHECK(pull_back(torus.equation(), patch).is_zero());
        const Rational t(3, 7);
        CHECK(patch(1, t) == torus_chart(frame, turns, 1 - i, j)(0, t));
        CHECK(patch(t, 1) == torus_chart(frame, turns, i, 1 - j)(t, 0));
        // One polynomial up to its factor.
        const BivariatePolynomial own = pull_back(f, patch), moved = on_other_half(first, i == 1, j == 1);
        CHECK(BivariatePolynomial::constant(moved(t, t)) * own ==
              BivariatePolynomial::constant(own(t, t)) * moved);
        CHECK(own(t, t) != 0);
      }
  }
  CHECK(!torus_frame(*S::torus(origin, {1, 1, 1}, 2, 1).data()));
  CHECK(!torus_frame(*S::torus(origin, up, Length::of_squared(5), 1).data()));
}

TEST_CASE("torus curves: the charts of either torus show the same") {
  const S torus = S::torus(origin, up, 5, 2);
  const auto both = [&](const S& other) {
    const Shape found = shape(torus, other);
    CHECK(shape(other, torus) == found);
    CHECK(shape(torus, by_equation(other)) == found);
    CHECK(shape(other, by_equation(torus)) == found);
    return found;
  };
  CHECK(both(S::torus({5, 0, 0}, {0, 1, 0}, 5, 2)) == Shape{{"complete", 1}});  // linked
  CHECK(both(S::torus(origin, right, 5, 2)) == Shape{{"complete", 1}, {"closed 1", 4}, {"crossing", 4}});
  CHECK(both(S::torus({3, 0, 1}, {2, 2, 1}, 4, 1)).contains("complete"));
  CHECK(both(S::torus({0, 1, 0}, {0, 3, 4}, Rational(9, 2), Rational(3, 2))).contains("complete"));
  // Side by side: contact in one point, and next to it.
  const auto beside = [&](const Rational& distance) { return both(S::torus({distance, 0, 0}, up, 5, 2)); };
  CHECK(beside(14) == Shape{{"complete", 1}, {"touch", 1}});
  for (const int k : {3, 6, 10, 20}) {
    CHECK(beside(14 + tenth_to(k)) == Shape{{"complete", 1}});
    CHECK(beside(14 - tenth_to(k)) == Shape{{"complete", 1}, {"closed 1", 1}});
  }
}

TEST_CASE("torus curves: contact along a common meridian") {
  // The circles in the middle touch in (5,0,0).
  const S first = S::torus(origin, up, 5, 1), second = S::torus({2, 0, 0}, up, 3, 1);
  const SurfaceIntersection result = intersect(first, second, within(1e-2));
  REQUIRE(result.status == Status::complete);
  int circles = 0;
  for (const SpaceCurve& curve : result.curves) {
    if (curve.multiplicity == 1) continue;
    ++circles;
    CHECK(curve.kind == SpaceCurveKind::circle);
    CHECK(curve.multiplicity == 2);
    CHECK(curve.point.value() == Point{5, 0, 0});
    CHECK(curve.radius_squared.value() == 1);
    CHECK(is_zero(cross(curve.direction.value(), {0, 1, 0})));
  }
  CHECK(circles == 1);
  CHECK(shape(second, by_equation(first)) == shape(first, second));
  CHECK(shape(S::torus({2 + tenth_to(20), 0, 0}, up, 3, 1), first).count("closed 2") == 0);
}

TEST_CASE("torus curves: polynomials and the quadrics that they are") {
  const S torus = S::torus({0, 0, Rational(1, 3)}, {2, -2, 1}, 5, 2);
  for (const S& other : {S::sphere({1, 2, 0}, 4), S::cylinder({1, 0, 0}, {1, 2, 3}, 2),
                         S::cone({0, 1, 0}, right, 1, 2), S::cylinder({5, 1, 0}, {0, 1, 0}, 1)})
    CHECK(shape(torus, by_equation(other)) == shape(torus, other));
  const S plane = S::plane({1, 0, 0}, {1, 2, 3});
  CHECK(shape(torus, by_equation(plane)) == shape(torus, plane));
  CHECK(shape(torus, by_equation(torus)) == Shape{{"same", 1}});
  const SpacePolynomial one = SpacePolynomial::constant(1);
  CHECK(shape(torus, S::polynomial(z * z + one)) == Shape{{"complete", 1}});
}

TEST_CASE("torus curves: circles about the axis have their data") {
  const S torus = S::torus({1, 2, 3}, up, 5, Rational(5, 6));
  const SpacePolynomial shifted = z - SpacePolynomial::constant(3);
  const SurfaceIntersection result = intersect(
      torus, S::polynomial(shifted * shifted - SpacePolynomial::constant(Rational(1, 4))), within(1e-3));
  REQUIRE(result.count(SpaceCurveKind::circle) == 4);
  std::map<Rational, int> radii;
  for (const SpaceCurve& circle : result.curves) {
    CHECK(*circle.direction == up);
    CHECK(abs(circle.point.value()[2] - 3) == Rational(1, 2));
    ++radii[circle.radius_squared.value()];
  }
  CHECK(radii == std::map<Rational, int>{{Rational(169, 9), 2}, {Rational(289, 9), 2}});
  for (const SpaceArc& arc : result.arcs) {
    CHECK(arc.error_bound < 0.02);
    const Rational squared = *result.curves[static_cast<std::size_t>(arc.curve)].radius_squared;
    for (const auto& p : arc.polyline) {
      const double r = std::hypot(p[0] - 1, p[1] - 2);
      CHECK(std::fabs(r - std::sqrt(to_double(squared))) <= arc.error_bound);
    }
  }
}

}  // namespace exsect::torus_curve_test
