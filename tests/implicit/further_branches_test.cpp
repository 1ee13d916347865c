#include <exsect/implicit/further_branches.h>

#include "geometry/curve_specimens.h"
#include "support/catch.h"

namespace exsect::further_branches_test {

namespace {

SpaceBox cube(const Rational& from, const Rational& to) {
  const RationalInterval side = {from, to};
  return {side, side, side};
}

SpacePolynomial variable(std::size_t axis) { return SpacePolynomial::variable(axis); }
SpacePolynomial constant(const Rational& c) { return SpacePolynomial::constant(c); }

bool contains(const SpaceBox& box, const Point& p) {
  for (std::size_t k = 0; k < 3; ++k)
    if (p[k] < box[k].lower || p[k] > box[k].upper) return false;
  return true;
}

}  // namespace

TEST_CASE("a line and its further branch are told apart", "[further_branches]") {
  // y = 0 and (z - x)(z - 3/4) = 0: the line z = x, and the line z = 3/4.
  const SurfacePair surfaces = {variable(1),
                                (variable(2) - variable(0)) * (variable(2) - constant(Rational(3, 4)))};
  const BezierCurve line({{0, 0, 0}, {Rational(1, 2), 0, Rational(1, 2)}});
  const FurtherBranches found =
      further_branches(surfaces, line, 0, cube(Rational(-1, 10), Rational(9, 10)), 4);
  CHECK(found.has_tube);
  REQUIRE(found.branches.size() == 1);
  const FurtherBranch& branch = found.branches.front();
  // The branch runs through the whole box; the crossing (3/4, 0, 3/4) of both belongs to it.
  CHECK(contains(branch.box, {0, 0, Rational(3, 4)}));
  CHECK(contains(branch.box, {Rational(3, 4), 0, Rational(3, 4)}));
  REQUIRE(branch.point);
  const SpaceBox& point = *branch.point;
  CHECK(contains(point, {point[0].midpoint(), 0, Rational(3, 4)}));
}

TEST_CASE("without further branches the tube is all", "[further_branches]") {
  const SurfacePair surfaces = {variable(1), variable(2) - variable(0)};
  const BezierCurve line({{0, 0, 0}, {Rational(1, 2), 0, Rational(1, 2)}});
  const FurtherBranches found =
      further_branches(surfaces, line, 0, cube(Rational(-1, 10), Rational(9, 10)), 4);
  CHECK(found.has_tube);
  CHECK(found.branches.empty());
  // Surfaces that do not meet in the box.
  const FurtherBranches none = further_branches(
      surfaces, line, 0,
      {{{Rational(2), Rational(3)}, {Rational(1), Rational(2)}, {Rational(0), Rational(1)}}}, 3);
  CHECK(none.branches.empty());
}

TEST_CASE("the cylinders of the space cubic", "[further_branches]") {
  const SurfacePair surfaces = cylinders(exact_projections(space_cubic(), 0));
  const FurtherBranches near = further_branches(surfaces, space_cubic(), 0, cube(0, Rational(6, 5)));
  CHECK(near.has_tube);
  CHECK(near.branches.empty());
  // In a larger box they meet again, in (x(t), y(t), z(s)) with x(s) = x(t).
  const FurtherBranches found = further_branches(surfaces, space_cubic(), 0, cube(-1, 2));
  CHECK_FALSE(found.branches.empty());
  for (const FurtherBranch& branch : found.branches) {
    if (!branch.point) continue;
    const SpaceBox& p = *branch.point;
    for (const SpacePolynomial& f : {surfaces.first, surfaces.second}) {
      bool above = false, below = false;
      for (int corner = 0; corner < 8; ++corner) {
        const auto end = [&](std::size_t k) { return (corner >> k & 1) != 0 ? p[k].upper : p[k].lower; };
        const Rational value = f({end(0), end(1), end(2)});
        above = above || value >= 0;
        below = below || value <= 0;
      }
      CHECK((above && below));
    }
    // No point of the curve is there.
    for (int k = 0; k <= 100; ++k) {
      const std::vector<Rational> q = space_cubic()(Rational(k, 100));
      CHECK_FALSE(contains(p, {q[0], q[1], q[2]}));
    }
  }
}

TEST_CASE("without a monotone coordinate there is no tube", "[further_branches]") {
  const BezierCurve turning({{0, 0, 0}, {1, 2, 0}, {2, 1, 3}, {0, 0, 1}});
  const SurfacePair surfaces = cylinders(exact_projections(turning, 0));
  const FurtherBranches found = further_branches(surfaces, turning, 0, cube(0, Rational(3, 2)), 3);
  CHECK_FALSE(found.has_tube);
  CHECK_FALSE(found.branches.empty());
  CHECK_THROWS_AS(further_branches(surfaces, turning, 0, cube(0, 1), 0), std::invalid_argument);
  CHECK_THROWS_AS(further_branches(surfaces, turning, 0, cube(0, 0), 3), std::invalid_argument);
}

}  // namespace exsect::further_branches_test
