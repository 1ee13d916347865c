#include <exsect/geometry/surface_box.h>
#include <exsect/solver/surface_ray.h>

#include "geometry/random_shapes.h"
#include "support/catch.h"

namespace exsect::surface_ray_test {
namespace {

const Point origin = {0, 0, 0}, up = {0, 0, 1};

std::vector<int> multiplicities(const RayIntersection& ray) {
  std::vector<int> result;
  for (const RayHit& hit : ray.hits) result.push_back(hit.multiplicity);
  return result;
}

TEST_CASE("rays and a sphere: a direction of length zero, starts on it, tangents and near misses") {
  const ImplicitSurface sphere = ImplicitSurface::sphere(origin, 1);
  CHECK_THROWS_AS(intersect_ray(origin, origin, sphere), std::invalid_argument);
  CHECK(intersect_ray({0, 0, 2}, up, sphere).hits.empty());
  const RayIntersection through = intersect_ray({0, 0, -3}, {0, 0, 2}, sphere);
  REQUIRE(multiplicities(through) == std::vector<int>{1, 1});
  CHECK(through.hits[0].t == RealAlgebraic(1));
  CHECK(through.hits[1].t == RealAlgebraic(2));
  CHECK(through.hits[0].contact == RayContact::transversal);
  CHECK(multiplicities(intersect_ray({0, 0, 1}, up, sphere)) == std::vector<int>{1});
  const RayIntersection tangent = intersect_ray({1, 0, -3}, up, sphere);
  REQUIRE(multiplicities(tangent) == std::vector<int>{2});
  CHECK(tangent.hits[0].t == RealAlgebraic(3));
  CHECK(tangent.hits[0].contact == RayContact::tangential);
  for (const long k : {10, 66, 300}) {
    CHECK(multiplicities(intersect_ray({1 - power_of_two(-k), 0, -3}, up, sphere)) == std::vector<int>{1, 1});
    CHECK(intersect_ray({1 + power_of_two(-k), 0, -3}, up, sphere).hits.empty());
  }
}

TEST_CASE("rays on surfaces, along rulings, through apexes") {
  const ImplicitSurface one = ImplicitSurface::cone(origin, up, 1),
                        two = ImplicitSurface::cone(origin, up, 1, 2);
  const RayIntersection upwards = intersect_ray({-1, 0, -1}, {1, 0, 1}, one);
  REQUIRE(upwards.overlaps.size() == 1);
  CHECK(upwards.overlaps[0].from == RealAlgebraic(1));
  CHECK_FALSE(upwards.overlaps[0].to);
  const RayIntersection downwards = intersect_ray({3, 0, 3}, {-2, 0, -2}, one);
  REQUIRE(downwards.overlaps.size() == 1);
  CHECK(downwards.overlaps[0].from == RealAlgebraic(0));
  REQUIRE(downwards.overlaps[0].to);
  CHECK(*downwards.overlaps[0].to == RealAlgebraic(Rational(3, 2)));
  CHECK(intersect_ray({-1, 0, -1}, {-1, 0, -1}, one).overlaps.empty());
  CHECK(intersect_ray({-1, 0, -1}, {-1, 0, -1}, two).overlaps.size() == 1);
  const RayIntersection apex = intersect_ray({-1, 0, 0}, {1, 0, 0}, one);
  REQUIRE(multiplicities(apex) == std::vector<int>{2});
  CHECK(apex.hits[0].contact == RayContact::singular);
  CHECK(multiplicities(intersect_ray({0, 0, -1}, {1, 0, 0}, one)).empty());
  CHECK(multiplicities(intersect_ray({0, 0, -1}, {1, 0, 0}, two)) == std::vector<int>{1});
  const ImplicitSurface plane = ImplicitSurface::plane(origin, up);
  CHECK(intersect_ray(origin, {1, 2, 0}, plane).overlaps.size() == 1);
  CHECK(intersect_ray({0, 0, 1}, {1, 2, 0}, plane).hits.empty());
  const ImplicitSurface cylinder = ImplicitSurface::cylinder(origin, {1, 1, 1}, Length::of_squared(2));
  CHECK(intersect_ray({1, -1, 0}, {-1, -1, -1}, cylinder).overlaps.size() == 1);
}

TEST_CASE("rays and a torus: four points, the inner equator, its top") {
  const ImplicitSurface torus = ImplicitSurface::torus(origin, up, 3, 1);
  const RayIntersection across = intersect_ray({-5, 0, 0}, {1, 0, 0}, torus);
  REQUIRE(multiplicities(across) == std::vector<int>{1, 1, 1, 1});
  for (const std::size_t k : {0U, 1U, 2U, 3U})
    CHECK(across.hits[k].t == RealAlgebraic(std::array{1, 3, 7, 9}[k]));
  CHECK(multiplicities(intersect_ray({2, -9, 0}, {0, 1, 0}, torus)) == std::vector<int>{1, 2, 1});
  CHECK(multiplicities(intersect_ray({-5, 0, 1}, {1, 0, 0}, torus)) == std::vector<int>{2, 2});
  CHECK(multiplicities(intersect_ray({0, -5, 1}, {1, 0, 0}, torus)).empty());
  CHECK(multiplicities(intersect_ray({3, -9, 1}, {0, 1, 0}, torus)) == std::vector<int>{4});
  CHECK(intersect_ray({0, 0, -5}, up, torus).hits.empty());
}

TEST_CASE("hits are the zeros that a product of known roots has") {
  const std::uint64_t seed = 26030;
  INFO("seed " << seed);
  Random random(seed);
  const SpacePolynomial x = SpacePolynomial::variable(0);
  for (int round = 0; round < 20; ++round) {
    SpacePolynomial f = SpacePolynomial::constant(1);
    std::vector<Rational> roots;
    for (int k = 0; k < 4; ++k) roots.push_back(random_rational(random, 4));
    for (const Rational& root : roots) f = f * (x - SpacePolynomial::constant(root));
    // On (t, ...) the zeros are the roots, with their multiplicities; those below 0 are behind.
    const RayIntersection ray =
        intersect_ray({0, 5, 7}, {1, random_rational(random), 1}, ImplicitSurface::polynomial(f));
    std::erase_if(roots, [](const Rational& root) { return root < 0; });
    std::sort(roots.begin(), roots.end());
    std::vector<Rational> found;
    for (const RayHit& hit : ray.hits)
      for (int k = 0; k < hit.multiplicity; ++k) {
        REQUIRE(std::any_of(roots.begin(), roots.end(),
                            [&](const Rational& r) { return hit.t == RealAlgebraic(r); }));
        found.push_back(*std::find_if(roots.begin(), roots.end(),
                                      [&](const Rational& r) { return hit.t == RealAlgebraic(r); }));
      }
    CHECK(found == roots);
  }
}

TEST_CASE("irrational hits are on the surface between their neighbours in doubles") {
  const ImplicitSurface sphere = ImplicitSurface::sphere(
      {from_double(1e8 + 0.1), from_double(-0.3), from_double(25.4)}, Length::of_squared(2));
  const Point from = {from_double(1e8), from_double(-4.7), from_double(25.3)}, along = {0, 1, 0};
  const RayIntersection ray = intersect_ray(from, along, sphere);
  REQUIRE(multiplicities(ray) == std::vector<int>{1, 1});
  for (const RayHit& hit : ray.hits) {
    const RationalInterval at = hit.t.refined_to(power_of_two(-80)).interval();
    CHECK(sphere.equation()(from + at.lower * along) * sphere.equation()(from + at.upper * along) < 0);
  }
}

TEST_CASE("rays meet the part of a surface in its box alone") {
  const ImplicitSurface pipe = ImplicitSurface::cylinder(origin, up, 1);
  const ImplicitSurface most = boxed(pipe, {.sector = AxisSector{{0, 1, 0}, {1, 0, 0}}});  // three quarters
  const RayIntersection across = intersect_ray({-5, 0, 0}, {1, 0, 0}, most);
  REQUIRE(multiplicities(across) == std::vector<int>{1, 1});  // the second on the end of the sector
  CHECK(multiplicities(intersect_ray({-5, -5, 0}, {1, 1, 0}, most)) == std::vector<int>{1});
  const ImplicitSurface piece = boxed(pipe, {.height = HeightRange{-1, 2}});
  CHECK(intersect_ray({-5, 0, 3}, {1, 0, 0}, piece).hits.empty());
  CHECK(multiplicities(intersect_ray({-5, 0, 2}, {1, 0, 0}, piece)) == std::vector<int>{1, 1});
  // Rulings: the part between the heights, from within, and none beside the sector.
  const RayIntersection ruling = intersect_ray({1, 0, -4}, {0, 0, 2}, piece);
  REQUIRE(ruling.overlaps.size() == 1);
  CHECK(ruling.overlaps[0].from == RealAlgebraic(Rational(3, 2)));
  CHECK(*ruling.overlaps[0].to == RealAlgebraic(3));
  CHECK(intersect_ray({1, 0, 0}, up, piece).overlaps[0].from == RealAlgebraic(0));
  CHECK(intersect_ray({1, 0, 3}, up, piece).overlaps.empty());
  CHECK(*intersect_ray({1, 0, 2}, up, piece).overlaps[0].to == RealAlgebraic(0));  // one point
  const Point beside = {Rational(3, 5), Rational(4, 5), 0};
  CHECK(intersect_ray(beside, up, most).overlaps.empty());
  CHECK_FALSE(intersect_ray({-1, 0, 0}, up, most).overlaps.at(0).to.has_value());
  const ImplicitSurface sheet = boxed(ImplicitSurface::plane(origin, up),
                                      {.sides = std::array<Point, 2>{Point{2, 0, 0}, Point{0, 3, 0}}});
  const RayIntersection line = intersect_ray({-1, -1, 0}, {1, 1, 0}, sheet);
  REQUIRE(line.overlaps.size() == 1);
  CHECK(line.overlaps[0].from == RealAlgebraic(1));
  CHECK(*line.overlaps[0].to == RealAlgebraic(3));
  const ImplicitSurface cones =
      boxed(ImplicitSurface::cone(origin, up, 1, 2), {.sector = AxisSector{{-1, 1, 0}, {1, 1, 0}}});
  CHECK(intersect_ray({0, -5, -5}, {0, 1, 1}, cones).overlaps.size() == 1);
}

}  // namespace
}  // namespace exsect::surface_ray_test
