// Branches of curves whose parts are known.
#include "lift/crossing_branches.h"

#include <algorithm>

#include "support/catch.h"

namespace exsect::crossing_branches_test {
namespace {

const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                      z = SpacePolynomial::variable(2);
SpacePolynomial number(const Rational& c) { return SpacePolynomial::constant(c); }

CrossingBranches branches_of(const SpacePolynomial& f, const SpacePolynomial& g) {
  const auto projection = space_projection(f, g, general_frame(0));
  REQUIRE(projection);
  const auto branches = crossing_branches(f, g, *projection);
  REQUIRE(branches);
  return *branches;
}

/// On which both surfaces of the branch have to be 0, and their gradients independent.
void check_crossing(const CrossingBranch& branch, const Point& p) {
  CHECK(branch.f(p) == 0);
  CHECK(branch.g(p) == 0);
  const auto gradient = [&](const SpacePolynomial& f) {
    return Point{f.derivative(0)(p), f.derivative(1)(p), f.derivative(2)(p)};
  };
  const Point along = cross(gradient(branch.f), gradient(branch.g));
  CHECK(!is_zero(along));
  CHECK(branch.rate(p) == dot(general_frame(0).height, along));
}

bool is_over(const CrossingBranch& branch, const Point& p) {
  const SpaceFrame frame = general_frame(0);
  return branch.shadow(dot(frame.height, p), dot(cross(frame.columns[2], frame.columns[0]), p)) == 0;
}

const SpacePolynomial ball = x * x + y * y + z * z - number(25);

}  // namespace

TEST_CASE("crossing branches: a curve of contact of each order") {
  // The circle z = 3 of the ball, on which (3,-4) / 5 and so on are rational points.
  SpacePolynomial power = z - number(3);
  for (int order = 1; order <= 4; ++order, power = power * (z - number(3))) {
    const CrossingBranches branches = branches_of(ball + power, ball);
    REQUIRE(branches.all.size() == 1);
    CHECK(branches.all[0].multiplicity == order);
    if (order > 1) CHECK(branches.all[0].f == z - number(3));
    for (const Point& p : {Point{4, 0, 3}, Point{0, -4, 3}, Point{Rational(16, 5), Rational(12, 5), 3}})
      check_crossing(branches.all[0], p);
    // u is extreme over two values, those over which the circle's tangent is orthogonal to the height.
    const Polynomial norm = squarefree_part(branches.norm);
    CHECK(norm.degree() == 2);
    CHECK(branches.projection.shadow.degree_s() == 2);
  }
}

TEST_CASE("crossing branches: a curve of contact and one that crosses it") {
  const SpacePolynomial touching = ball * (x + number(1)) + (z - number(3)) * (z - number(3)) * (y - x);
  const CrossingBranches branches = branches_of(touching, ball);
  REQUIRE(branches.all.size() == 2);
  std::vector<CrossingBranch> all = branches.all;
  std::ranges::sort(all, {}, &CrossingBranch::multiplicity);
  CHECK(all[0].multiplicity == 1);
  CHECK(all[1].multiplicity == 2);
  check_crossing(all[1], {4, 0, 3});
  // Where they meet, at x = y = +-sqrt 8, the norm is 0 more than once.
  const Point& h = general_frame(0).height;
  const Rational mean = 3 * h[2], rate = h[0] + h[1];
  const Polynomial where{mean * mean - 8 * rate * rate, -2 * mean, 1};
  CHECK(divide(branches.norm, where * where).remainder.is_zero());
}

TEST_CASE("crossing branches: no plane through a line that touches the other surface on it") {
  // The plane y = 0 has a second line in common with the saddle, which crosses the first one in the origin.
  const SpacePolynomial saddle = x * z - y;
  for (const Rational shift : {0, 2, -5}) {
    const SpacePolynomial other = saddle * (x + number(3)) + z * z * (y - number(shift));
    for (const CrossingBranch& branch : branches_of(other, saddle).all)
      if (branch.multiplicity == 2)
        for (const int k : {-2, 0, 1, 4}) check_crossing(branch, {Rational(k), 0, 0});
  }
}

TEST_CASE("crossing branches: squares, and curves along which a surface is singular") {
  const SpacePolynomial tube = x * x + y * y - number(16);
  for (const auto& [f, g] : {std::pair(tube * tube, ball), std::pair(ball, tube * tube)}) {
    const CrossingBranches branches = branches_of(f, g);
    REQUIRE(branches.all.size() == 2);  // z = 3 and z = -3
    for (const CrossingBranch& branch : branches.all) {
      CHECK(branch.multiplicity == 2);
      const Point above = {4, 0, 3}, below = {4, 0, -3};
      CHECK(is_over(branch, above) != is_over(branch, below));
      check_crossing(branch, is_over(branch, above) ? above : below);
    }
  }
  const auto projection = space_projection(tube * tube, ball * ball, general_frame(0));
  REQUIRE(projection);
  CHECK(!crossing_branches(tube * tube, ball * ball, *projection));
}

}  // namespace exsect::crossing_branches_test
