#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/patch_ray.h>

#include "geometry/random_shapes.h"
#include "support/catch.h"

namespace exsect::patch_ray_test {
namespace {

const Point up = {0, 0, 1};
using Net = std::vector<std::vector<Point>>;
using Weights = std::vector<std::vector<Rational>>;

RationalPatch square() { return RationalPatch(Net{{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}}}); }
// z = u v
RationalPatch saddle() { return RationalPatch(Net{{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 1}}}); }
// A quarter of the cylinder x^2 + y^2 = 1, 0 <= z <= 1.
RationalPatch cylinder() {
  return RationalPatch(Net{{{1, 0, 0}, {1, 0, 1}}, {{1, 1, 0}, {1, 1, 1}}, {{0, 1, 0}, {0, 1, 1}}},
                       Weights{{1, 1}, {1, 1}, {2, 2}});
}
// An eighth of the unit sphere, its pole at v = 1.
RationalPatch sphere() {
  return RationalPatch(Net{{{1, 0, 0}, {1, 0, 1}, {0, 0, 1}},
                           {{1, 1, 0}, {1, 1, 1}, {0, 0, 1}},
                           {{0, 1, 0}, {0, 1, 1}, {0, 0, 1}}},
                       Weights{{1, 1, 2}, {1, 1, 2}, {2, 2, 4}});
}

std::vector<int> multiplicities(const RayIntersection& ray) {
  CHECK_FALSE(ray.incomplete);
  std::vector<int> result;
  for (const RayHit& hit : ray.hits) result.push_back(hit.multiplicity);
  return result;
}

TEST_CASE("rays and patches: planes, sides, corners, the wrong way, a direction of length zero") {
  CHECK_THROWS_AS(intersect_ray({0, 0, 0}, {0, 0, 0}, square()), std::invalid_argument);
  const RayIntersection through = intersect_ray({Rational(1, 3), Rational(1, 7), -2}, up, square());
  REQUIRE(multiplicities(through) == std::vector<int>{1});
  CHECK(through.hits[0].t == RealAlgebraic(2));
  CHECK(through.hits[0].contact == RayContact::transversal);
  REQUIRE(through.hits[0].parameters);
  CHECK(sign_at(BivariatePolynomial::r() - BivariatePolynomial::constant(Rational(1, 3)),
                *through.hits[0].parameters) == 0);
  CHECK(sign_at(BivariatePolynomial::s() - BivariatePolynomial::constant(Rational(1, 7)),
                *through.hits[0].parameters) == 0);
  CHECK(multiplicities(intersect_ray({1, 1, -2}, up, square())) == std::vector<int>{1});
  CHECK(multiplicities(intersect_ray({1, Rational(1, 2), 0}, up, square())) == std::vector<int>{1});
  CHECK(multiplicities(intersect_ray({1, 1, 1}, up, square())).empty());
  CHECK(multiplicities(intersect_ray({1 + power_of_two(-300), 1, -2}, up, square())).empty());
  CHECK(multiplicities(intersect_ray({0, 0, 1}, {1, 0, 0}, square())).empty());
}

TEST_CASE("rays in patches: intervals of the ray, from its start on, and one point") {
  const RayIntersection in = intersect_ray({-1, Rational(1, 2), 0}, {2, 0, 0}, square());
  CHECK(in.hits.empty());
  REQUIRE(in.overlaps.size() == 1);
  CHECK(in.overlaps[0].from == RealAlgebraic(Rational(1, 2)));
  CHECK(*in.overlaps[0].to == RealAlgebraic(1));
  const RayIntersection inside = intersect_ray({Rational(1, 2), Rational(1, 2), 0}, {1, 1, 0}, square());
  REQUIRE(inside.overlaps.size() == 1);
  CHECK(inside.overlaps[0].from == RealAlgebraic(0));
  CHECK(*inside.overlaps[0].to == RealAlgebraic(Rational(1, 2)));
  CHECK(intersect_ray({2, Rational(1, 2), 0}, {2, 0, 0}, square()).overlaps.empty());
  const RayIntersection start = intersect_ray({1, Rational(1, 2), 0}, {2, 0, 0}, square());
  CHECK(start.overlaps.empty());
  REQUIRE(multiplicities(start) == std::vector<int>{0});
  CHECK(start.hits[0].t == RealAlgebraic(0));
  // A ruling of the saddle, and the side of the cylinder.
  CHECK(intersect_ray({Rational(1, 2), 0, 0}, {0, 2, 1}, saddle()).overlaps.size() == 1);
  CHECK(intersect_ray({1, 0, -1}, up, cylinder()).overlaps.size() == 1);
  // The parabola z = x^2 in the saddle's plane x = y touches the ray: no part of it.
  CHECK(multiplicities(intersect_ray({0, 0, 0}, {1, 1, 0}, saddle())) == std::vector<int>{2});
  // A square run through twice in u: z = 0, x = 4 u (1 - u); the hit of multiplicity 2 is a fold.
  const RationalPatch folded(Net{{{0, 0, 0}, {0, 1, 0}}, {{2, 0, 0}, {2, 1, 0}}, {{0, 0, 0}, {0, 1, 0}}});
  const RayIntersection fold = intersect_ray({1, Rational(1, 2), -1}, up, folded);
  REQUIRE(multiplicities(fold) == std::vector<int>{2});
  CHECK(fold.hits[0].contact == RayContact::singular);
  CHECK(multiplicities(intersect_ray({Rational(1, 2), Rational(1, 2), -1}, up, folded)) ==
        std::vector<int>{1, 1});
  const RayIntersection along = intersect_ray({-1, Rational(1, 2), 0}, {1, 0, 0}, folded);
  REQUIRE(along.overlaps.size() == 1);
  CHECK(along.overlaps[0].from == RealAlgebraic(1));
  CHECK(*along.overlaps[0].to == RealAlgebraic(2));
}

TEST_CASE("rays and round patches: the same points as with the equation, the pole, a tangent") {
  const RayIntersection pole = intersect_ray({0, 0, -1}, up, sphere());
  REQUIRE(multiplicities(pole) == std::vector<int>{0});
  CHECK(pole.hits[0].t == RealAlgebraic(2));
  CHECK(pole.hits[0].contact == RayContact::singular);
  CHECK_FALSE(pole.hits[0].parameters);
  const RayIntersection tangent = intersect_ray({-1, Rational(3, 5), Rational(4, 5)}, {1, 0, 0}, sphere());
  REQUIRE(multiplicities(tangent) == std::vector<int>{2});
  CHECK(tangent.hits[0].contact == RayContact::tangential);
  CHECK(multiplicities(
            intersect_ray({-1, Rational(3, 5), Rational(4, 5) + power_of_two(-200)}, {1, 0, 0}, sphere()))
            .empty());
  const std::uint64_t seed = 26110;
  INFO("seed " << seed);
  Random random(seed);
  const ImplicitSurface equation = ImplicitSurface::sphere({0, 0, 0}, 1);
  for (int round = 0; round < 12; ++round) {
    const Point from = random_point(random), along = random_point(random);
    if (is_zero(along)) continue;
    std::vector<RealAlgebraic> expected;
    for (const RayHit& hit : intersect_ray(from, along, equation).hits) {
      const bool inside = std::all_of(from.begin(), from.end(), [&](const Rational& a) {
        const auto k = static_cast<std::size_t>(&a - from.data());
        return sign_at(Polynomial{from[k], along[k]}, hit.t) >= 0;
      });
      if (inside) expected.push_back(hit.t);
    }
    const RayIntersection found = intersect_ray(from, along, sphere());
    REQUIRE(multiplicities(found).size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) CHECK(found.hits[k].t == expected[k]);
  }
}

TEST_CASE("rays and patches: a motion, a scale and exchanged parameters keep the points") {
  const std::uint64_t seed = 26111;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 6; ++round) {
    Net net(4, std::vector<Point>(3)), moved = net;
    Weights weights(4, std::vector<Rational>(3));
    const Rational scale = from_double(25.4);
    const Point shift = {from_double(1e8 + 0.1), from_double(-0.3), 7};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        net[i][j] = random_point(random);
        moved[i][j] = scale * net[i][j] + shift;
        weights[i][j] = 1 + abs(random_rational(random));
      }
    const RationalPatch x(net, weights), y(moved, weights);
    // Through a point of the patch, so that there is one.
    const Point from = random_point(random), to = x(Rational(1, 3), Rational(2, 5));
    const RayIntersection here = intersect_ray(from, to - from, x);
    const RayIntersection there = intersect_ray(scale * from + shift, to - from, y);
    const RayIntersection exchanged = intersect_ray(from, to - from, x.transposed());
    REQUIRE(multiplicities(here) == multiplicities(there));
    REQUIRE(multiplicities(here) == multiplicities(exchanged));
    CHECK(std::any_of(here.hits.begin(), here.hits.end(),
                      [](const RayHit& hit) { return hit.t == RealAlgebraic(1); }));
    for (std::size_t k = 0; k < here.hits.size(); ++k) {
      CHECK(here.hits[k].t == exchanged.hits[k].t);
      const RationalInterval t = there.hits[k].t.refined_to(power_of_two(-60)).interval();
      CHECK(here.hits[k].t.compare(t.lower / scale) >= 0);
      CHECK(here.hits[k].t.compare(t.upper / scale) <= 0);
    }
  }
}

}  // namespace
}  // namespace exsect::patch_ray_test
