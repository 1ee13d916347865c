#include <exsect/implicit/revolution_patch.h>

#include <algorithm>
#include <cmath>

#include "geometry/random_shapes.h"
#include "support/catch.h"

namespace exsect::revolution_patch_test {
namespace {

const BivariatePolynomial r = BivariatePolynomial::r();
const BivariatePolynomial z = BivariatePolynomial::s();
BivariatePolynomial number(const Rational& q) { return BivariatePolynomial::constant(q); }

/// (x,y,z) = (a + b u, c + d v, h).
BezierPatch flat(const Rational& a, const Rational& b, const Rational& c, const Rational& d,
                 const Rational& h) {
  ControlNet net;
  for (auto& row : net) row.fill({0, 0, 0});
  net[0][0] = {a, c, h};
  net[1][0] = {b, 0, 0};
  net[0][1] = {0, d, 0};
  return BezierPatch::from_power_basis(net);
}

const BivariatePolynomial torus = r * r - number(4) * r + number(3) + z * z;  // (r - 2)^2 + z^2 = 1

TEST_CASE("a plane cuts the torus in two circles", "[revolution_patch]") {
  const BezierPatch plane = flat(-4, 8, -4, 8, Rational(1, 3));
  const RevolutionPatchCurve curve = intersect_revolution(torus, plane);
  CHECK(curve.equation.degree_r() == 4);
  CHECK(curve.whole_sides.empty());
  const std::vector<CurveComponent> all =
      components(curve.arcs, std::vector<bool>(curve.arcs.arcs.size(), true));
  CHECK(all.size() == 2);
  CHECK(std::all_of(all.begin(), all.end(), [](const CurveComponent& c) { return c.closed; }));
  REQUIRE(curve.sheets.size() == curve.arcs.arcs.size());
  CHECK(std::all_of(curve.sheets.begin(), curve.sheets.end(), [](Sheet s) { return s == Sheet::own; }));
  const RevolutionPatchLine line = points_on_line(torus, plane, Rational(1, 2));
  CHECK(line.points.size() == 4);
  CHECK_FALSE(line.whole_line);
  CHECK_THROWS_AS(points_on_line(torus, plane, 2), std::invalid_argument);
}

TEST_CASE("the mirrored sheet is told from the own one", "[revolution_patch]") {
  // The mirrored copy of (r + 2)^2 + z^2 = 1 is the torus.
  const BivariatePolynomial mirrored = r * r + number(4) * r + number(3) + z * z;
  const BezierPatch plane = flat(-4, 8, -4, 8, Rational(1, 3));
  const RevolutionPatchCurve curve = intersect_revolution(mirrored, plane);
  REQUIRE_FALSE(curve.sheets.empty());
  CHECK(std::all_of(curve.sheets.begin(), curve.sheets.end(), [](Sheet s) { return s == Sheet::mirrored; }));
  for (const RevolutionPatchPoint& p : points_on_line(mirrored, plane, Rational(2, 5)).points)
    CHECK(p.sheet == Sheet::mirrored);
}

TEST_CASE("special positions of the patch", "[revolution_patch]") {
  CHECK_THROWS_AS(intersect_revolution({}, flat(0, 1, 0, 1, 0)), std::domain_error);
  // the whole patch on the plane z = 0
  CHECK(intersect_revolution(z, flat(0, 1, 0, 1, 0)).equation.is_zero());
  CHECK(points_on_line(z, flat(0, 1, 0, 1, 0), 0).whole_line);
  // the cylinder r = 1 (even: r^2 - 1), a plane through the axis: lines; the side v = 0 is y = 0
  const RevolutionPatchCurve circle = intersect_revolution(r * r - number(1), flat(-2, 4, -2, 4, 0));
  CHECK(components(circle.arcs, std::vector<bool>(circle.arcs.arcs.size(), true)).size() == 1);
  // the plane y = 0 as cone of the profile: z = r and a patch with its side on the surface
  ControlNet net;
  for (auto& row : net) row.fill({0, 0, 0});
  net[0][0] = {1, 0, 1};
  net[1][0] = {1, 0, 1};
  net[0][1] = {0, 0, 1};
  const RevolutionPatchCurve side = intersect_revolution(z - r, BezierPatch::from_power_basis(net));
  CHECK(side.whole_sides == std::vector<int>{0});
}

TEST_CASE("points on lines lie on the surface and count as the arcs say", "[revolution_patch]") {
  const std::uint64_t seed = 20260118;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 3; ++round) {
    ControlNet net = random_net(random);
    for (auto& row : net)
      for (Point& p : row) p = Rational(1, 5) * p;
    const BezierPatch patch(net);
    const BivariatePolynomial f = torus - number(Rational(round, 2)) * r * z;
    const RevolutionPatchCurve curve = intersect_revolution(f, patch);
    for (const CurveGap& gap : curve.arcs.gaps) {
      const RevolutionPatchLine line = points_on_line(f, patch, gap.sample);
      REQUIRE(line.points.size() == gap.arcs.size());
      for (std::size_t i = 0; i < line.points.size(); ++i) {
        CHECK(line.points[i].sheet == curve.sheets[gap.arcs[i]]);
        const RealAlgebraic v = line.points[i].v.refined_to(power_of_two(-60));
        const Point p = patch(gap.sample, v.interval().midpoint());
        const double radius = std::sqrt(to_double(p[0] * p[0] + p[1] * p[1])), height = to_double(p[2]);
        const double sign = line.points[i].sheet == Sheet::own ? 1 : -1;
        CHECK(std::abs(to_double(f(from_double(sign * radius), from_double(height)))) < 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace exsect::revolution_patch_test
