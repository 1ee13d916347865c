// Patches with inverses of forms: which they are, and that the inverse is one.
#include "special/patch_inverse.h"

#include "solver/special/revolved.h"
#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::patch_inverse_test {
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

Rational value(const SpaceForm& form, const HomogeneousPoint& x) {
  VectorPolynomial at;
  for (std::size_t k = 0; k < 4; ++k) at[k] = BivariatePolynomial::constant(x[k]);
  return on_patch(form, at)(0, 0);
}

Rational mapped(const UnitMap& map, const Rational& p) {
  const Rational a = (1 - p) * (1 + map.start * p), b = p * (1 + map.end * (1 - p));
  return b / (a + b);
}

/// (17.23) on a grid of the square, and the equation.
PatchInverse check_inverse(const RationalPatch& y, std::size_t terms, bool has_poles = false) {
  const auto inverse = patch_inverse(y);
  REQUIRE(inverse);
  CHECK(inverse->equation.coefficients.size() == terms);
  CHECK(on_patch(inverse->equation, components(y)).is_zero());
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; j <= 4; ++j) {
      const std::array<Rational, 2> at = {Rational(i, 4), Rational(j, 4)};
      const HomogeneousPoint x = y.homogeneous_at(at[0], at[1]);
      for (const std::size_t k : {0, 1}) {
        const auto& [numerator, denominator, bound, map] = inverse->parameters[k];
        CHECK(value(numerator, x) == mapped(map, at[k]) * value(denominator, x));
        CHECK((has_poles ? bound >= 0 : bound > 0));
        Rational weight = bound * x[3];
        if (denominator.degree == 2) weight *= x[3];
        CHECK((value(denominator, x) > weight || (bound == 0 && value(denominator, x) == 0)));
      }
    }
  return *inverse;
}

const revolved::Arc3 kQuarter = {{1, 0, 1}, {1, 1, 1}, {0, 2, 2}};

}  // namespace

TEST_CASE("patch inverse: planes, bilinear patches, cylinders and cones in any place and parameters") {
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

TEST_CASE("patch inverse: none of other patches") {
  // The lines of one parameter of a quadrilateral without parallel sides touch a conic.
  CHECK_FALSE(patch_inverse(bilinear({0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {5, 4, 0})));
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    CHECK_FALSE(patch_inverse(random_nets::crossing(generator, {2, 2, 2, 2}, false).first()));
    CHECK_FALSE(patch_inverse(
        random_nets::weighted(generator, random_nets::crossing(generator, {3, 3, 1, 1}, false).x)));
    CHECK_FALSE(patch_inverse(
        random_nets::weighted(generator, random_nets::crossing(generator, {2, 1, 1, 1}, false).x)));
  }
}

TEST_CASE("patch inverse: surfaces of revolution") {
  struct Revolved {
    const char* name;
    RationalPatch patch;
    std::size_t terms;
    bool has_pole;
  };
  const revolved::Arc3 wide = revolved::arc(Rational(-2, 3), Rational(2, 3));
  const std::vector<Revolved> patches = {
      {"torus outside", revolved::patch(revolved::moved(kQuarter, 1, 3), kQuarter), 35, false},
      {"torus over the top",
       revolved::patch(revolved::moved({{1, 0, 1}, {0, 1, 0}, {-1, 0, 1}}, 1, 3), kQuarter), 35, false},
      {"torus, wide", revolved::patch(revolved::moved(wide, -1, 3), wide), 35, false},
      {"sphere with a pole", revolved::patch(kQuarter, kQuarter), 10, true},
      {"spherical zone", revolved::patch(wide, kQuarter), 10, false},
      {"ellipsoid", revolved::patch({{2, 0, 1}, {2, 3, 1}, {0, 6, 2}}, kQuarter), 10, true},
      {"paraboloid", revolved::patch({{0, 0, 1}, {1, 0, 1}, {2, 4, 1}}, kQuarter), 10, true},
      {"parabola about a line", revolved::patch({{3, 0, 1}, {4, 2, 1}, {3, 3, 1}}, kQuarter), 35, false},
      {"cone with its apex", rulings(0, 1, 0), 10, true}};
  for (const auto& [name, patch, terms, has_pole] : patches)
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      INFO(name << ", seed " << seed);
      Generator generator(seed);
      const auto map = random_nets::projective_map(generator);
      check_inverse(patch, terms, has_pole);
      check_inverse(patch.transposed(), terms, has_pole);
      check_inverse(random_nets::reparametrised(random_nets::image(patch, map), Rational(7, 3)), terms,
                    has_pole);
      check_inverse(patch.restricted_to(Rational(3, 4), Rational(1, 3), Rational(1, 5), 1), terms, has_pole);
    }
}

TEST_CASE("patch inverse: graphs of polynomials of degree 3 and 4") {
  for (const int degree : {3, 4})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      INFO("degree " << degree << ", seed " << seed);
      Generator generator(seed);
      // Over i/3, j/3: the Bernstein coefficients of u and v, and of heights with a term u^3, and u^2 v^2.
      std::vector<std::vector<Point>> net(4);
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
          const Rational cubic = i == 3 ? 2 : 0;
          const Rational quartic =
              degree == 4 && i >= 2 && j >= 2 ? Rational((2 * i - 3) * (2 * j - 3), 9) : 0;
          net[static_cast<std::size_t>(i)].push_back({Rational(i, 3), Rational(j, 3), cubic + quartic});
        }
      const RationalPatch graph(net);
      const std::size_t terms = degree == 3 ? 20 : 35;
      check_inverse(graph, terms);
      check_inverse(random_nets::image(graph, random_nets::projective_map(generator)), terms);
      check_inverse(random_nets::reparametrised(graph, Rational(2, 5)), terms);
    }
}

TEST_CASE("patch inverse: the point of another sheet with the same quotients is told by its sign") {
  // On the sphere and on the torus, half a turn about the axis.
  for (const Rational& distance : {Rational(0), Rational(3)}) {
    const RationalPatch y = revolved::patch(
        revolved::moved(revolved::arc(Rational(-1, 2), Rational(1, 2)), 1, distance), kQuarter);
    const auto inverse = patch_inverse(y);
    REQUIRE(inverse);
    HomogeneousPoint x = y.homogeneous_at(Rational(1, 3), Rational(1, 4));
    x[0] = -x[0];
    x[1] = -x[1];
    CHECK(value(inverse->equation, x) == 0);
    const ParameterQuotient& turn = inverse->parameters[1];
    CHECK_FALSE(turn.map.is_identity());
    CHECK(value(turn.numerator, x) == mapped(turn.map, Rational(1, 4)) * value(turn.denominator, x));
    CHECK(value(turn.denominator, x) < 0);
  }
}

TEST_CASE("patch inverse: the equation vanishes on the surface alone") {
  for (const auto& [name, patch, terms] : surfaces()) {
    INFO(name);
    const auto inverse = patch_inverse(patch);
    REQUIRE(inverse);
    const RationalPatch moved = random_nets::image(
        patch, {{{1, 0, 0, 0}, {0, 1, 0, Rational(1, 100)}, {0, 0, 1, Rational(1, 70)}, {0, 0, 0, 1}}});
    CHECK_FALSE(on_patch(inverse->equation, components(moved)).is_zero());
  }
}

}  // namespace exsect::patch_inverse_test
