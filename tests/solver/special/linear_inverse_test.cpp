// Patches with linear inverses: which they are, and that the inverse is one.
#include "special/linear_inverse.h"

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::linear_inverse_test {
namespace {

using random_nets::Generator;
using Net = std::vector<std::vector<HomogeneousPoint>>;

/// (w x, w y, w) over a quarter of a circle, along a direction; `from` and `to` scale the circle.
RationalPatch rulings(const Rational& from, const Rational& to, const Rational& shear) {
  Net net;
  for (const auto& [x, y, w] : std::vector<std::array<Rational, 3>>{{1, 0, 1}, {1, 1, 1}, {0, 2, 2}})
    net.push_back({{from * x, from * y, 0, w}, {to * x + shear * w, to * y, 3 * w, w}});
  return RationalPatch::from_homogeneous(net);
}

RationalPatch bilinear(const Point& a, const Point& b, const Point& c, const Point& d) {
  return RationalPatch({{a, b}, {c, d}});
}

struct Surface {
  const char* name;
  RationalPatch patch;
  std::size_t terms;  // of its equation
};
std::vector<Surface> surfaces() {
  return {{"parallelogram", bilinear({0, 0, 0}, {3, 1, 0}, {1, 2, 0}, {4, 3, 0}), 4},
          {"trapezoid", bilinear({0, 0, 0}, {6, 0, 0}, {1, 2, 1}, {3, 2, 1}), 4},
          {"saddle", bilinear({0, 0, 0}, {3, 1, 0}, {1, 2, 0}, {4, 3, 2}), 10},
          {"cylinder", rulings(1, 1, 0), 10},
          {"oblique cylinder", rulings(1, 1, 2), 10},
          {"cone", rulings(1, 3, 0), 10},
          {"oblique cone", rulings(3, 1, 1), 10}};
}

Rational value(const LinearForm& form, const HomogeneousPoint& x) {
  return form[0] * x[0] + form[1] * x[1] + form[2] * x[2] + form[3] * x[3];
}

/// (17.23) on a grid of the square, and the equation.
void check_inverse(const RationalPatch& y, std::size_t terms) {
  const auto inverse = linear_inverse(y);
  REQUIRE(inverse);
  CHECK(inverse->equation.size() == terms);
  CHECK(section_of(*inverse, y).is_zero());
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; j <= 4; ++j) {
      const std::array<Rational, 2> at = {Rational(i, 4), Rational(j, 4)};
      const HomogeneousPoint x = y.homogeneous_at(at[0], at[1]);
      for (const std::size_t k : {0, 1}) {
        const auto& [numerator, denominator, bound] = inverse->parameters[k];
        CHECK(value(numerator, x) == at[k] * value(denominator, x));
        CHECK(bound > 0);
        CHECK(value(denominator, x) > bound * x[3]);
      }
    }
}

}  // namespace

TEST_CASE("linear inverse: planes, bilinear patches, cylinders and cones in any place and parameters") {
  for (const auto& [name, patch, terms] : surfaces())
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      INFO(name << ", seed " << seed);
      Generator generator(seed);
      const auto map = random_nets::projective_map(generator);
      check_inverse(patch, terms);
      check_inverse(patch.transposed(), terms);
      check_inverse(patch.elevated(3, 2), terms);
      check_inverse(random_nets::image(patch, map), terms);
      check_inverse(random_nets::reparametrised(random_nets::image(patch, map), Rational(7, 3)), terms);
      check_inverse(patch.restricted_to(Rational(3, 4), Rational(1, 3), Rational(1, 5), 1), terms);
      const Rational far(100000000);
      check_inverse(
          random_nets::image(patch, {{{1, 0, 0, far}, {0, 1, 0, -far}, {0, 0, 1, far}, {0, 0, 0, 1}}}),
          terms);
    }
}

TEST_CASE("linear inverse: none of other patches") {
  // The lines of one parameter of a quadrilateral without parallel sides touch a conic.
  CHECK_FALSE(linear_inverse(bilinear({0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {5, 4, 0})));
  CHECK_FALSE(linear_inverse(rulings(0, 1, 0)));  // a cone with its apex
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    CHECK_FALSE(linear_inverse(random_nets::crossing(generator, {2, 2, 2, 2}, false).first()));
    CHECK_FALSE(linear_inverse(
        random_nets::weighted(generator, random_nets::crossing(generator, {3, 3, 1, 1}, false).x)));
    CHECK_FALSE(linear_inverse(
        random_nets::weighted(generator, random_nets::crossing(generator, {2, 1, 1, 1}, false).x)));
  }
}

TEST_CASE("linear inverse: the equation vanishes on the surface alone") {
  for (const auto& [name, patch, terms] : surfaces()) {
    INFO(name);
    const auto inverse = linear_inverse(patch);
    REQUIRE(inverse);
    const RationalPatch moved = random_nets::image(
        patch, {{{1, 0, 0, 0}, {0, 1, 0, Rational(1, 100)}, {0, 0, 1, Rational(1, 70)}, {0, 0, 0, 1}}});
    CHECK_FALSE(section_of(*inverse, moved).is_zero());
  }
}

}  // namespace exsect::linear_inverse_test
