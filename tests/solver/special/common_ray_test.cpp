// Parameter lines that are one curve: parabolas and circles out of a pole, reparametrised.
#include "special/common_ray.h"

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::common_ray_test {
namespace {

using random_pairs::Generator;

/// A patch with the pole in the origin at random, with weights, of which the line t = 1/2 does not depend on
/// `beside`.
RationalPatch sheaf(Generator& generator, const Point& beside) {
  const auto number = [&] { return Rational(random_pairs::integer(generator, 1, 9), 7); };
  std::vector<std::vector<HomogeneousPoint>> net(3, std::vector<HomogeneousPoint>(3, {0, 0, 0, 1}));
  for (std::size_t i = 1; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) net[i][j] = {number(), number(), number(), number()};
  for (std::size_t c = 0; c < 3; ++c) {
    net[2][0][c] += beside[c];  // (1 - t)^2 and t^2 are 1/4 at t = 1/2
    net[2][2][c] -= beside[c];
  }
  return RationalPatch::from_homogeneous(net);
}

/// a = 2 a' / (3 - a') in place of a.
RationalPatch bent(const RationalPatch& x) {
  std::vector<std::vector<HomogeneousPoint>> net(3, std::vector<HomogeneousPoint>(3));
  const std::array<Rational, 3> factor = {9, 6, 4};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (std::size_t c = 0; c < 4; ++c)
        net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)][c] =
            factor[static_cast<std::size_t>(i)] * x.homogeneous(i, j)[c];
  return RationalPatch::from_homogeneous(net);
}

}  // namespace

TEST_CASE("common_ray: a line that two patches share, under a Möbius map, and no other") {
  const Rational half(1, 2);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    Generator one(seed), same(seed), third(seed);
    const RationalPatch x = sheaf(one, {0, 0, 0}), y = bent(sheaf(same, {1, Rational(1, 3), 2}));
    const auto ray = common_ray(x, y, half, half);
    REQUIRE(ray);
    for (const Rational& a : {Rational(1, 5), Rational(2, 3)})
      CHECK(x(a, half) == y(ray->ratio * a / (1 + ray->bend * a), half));
    CHECK(!ray->is_contact);
    CHECK(!common_ray(x, y, half, Rational(1, 3)));
    CHECK(!common_ray(x, y, Rational(1, 3), half));
    const auto itself = common_ray(x, bent(sheaf(third, {0, 0, 0})), half, half);
    REQUIRE(itself);
    CHECK(itself->is_contact);
    CHECK(itself->ratio == ray->ratio);
    CHECK(itself->bend == ray->bend);
  }
}

TEST_CASE("common_ray: curves of one direction and curvature that are not one curve") {
  // b (1,0,0) + b^2 (0,0,1), and the same with a third coefficient.
  const auto along = [](const Rational& third) {
    const Point o = {0, 0, 0}, p = {Rational(1, 3), 0, 0}, q = {Rational(2, 3), 0, Rational(1, 3)};
    return RationalPatch(
        {{o, o}, {p, p + Point{0, 1, 0}}, {q, q + Point{0, 2, 0}}, {{1, 0, 1 + third}, {1, 3, 1 + third}}});
  };
  CHECK(common_ray(along(0), along(0), 0, 0));
  CHECK(!common_ray(along(0), along(power_of_two(-100)), 0, 0));
  CHECK(!common_ray(along(power_of_two(-100)), along(0), 0, 0));
  CHECK(!common_ray(along(0), RationalPatch({{{0, 0, 0}, {0, 0, 0}}, {{-1, 0, 0}, {-1, 1, 0}}}), 0, 0));
}

}  // namespace exsect::common_ray_test
