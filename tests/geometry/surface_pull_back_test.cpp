#include <exsect/geometry/implicit_surface.h>
#include <exsect/geometry/surface_pull_back.h>

#include "random_shapes.h"
#include "support/catch.h"

namespace exsect::surface_pull_back_test {
namespace {

Rational power(const Rational& base, int exponent) {
  Rational value = 1;
  for (int i = 0; i < exponent; ++i) value *= base;
  return value;
}

SpacePolynomial random_equation(Random& random, int degree) {
  SpacePolynomial::Terms terms;
  for (const Exponents& e : exponents_up_to(degree)) terms[e] = random_rational(random);
  return SpacePolynomial(terms);
}

TEST_CASE("the pull back to a patch is its definition, of degree e m and e n") {
  const std::uint64_t seed = 26003;
  INFO("seed " << seed);
  Random random(seed);
  for (int m = 1; m <= 3; ++m)
    for (int n = 1; n <= 3; ++n)
      for (int degree = 1; degree <= 4; ++degree) {
        std::vector<std::vector<Point>> points(static_cast<std::size_t>(m + 1));
        std::vector<std::vector<Rational>> weights(static_cast<std::size_t>(m + 1));
        for (std::size_t i = 0; i < points.size(); ++i)
          for (int j = 0; j <= n; ++j) {
            points[i].push_back(random_point(random));
            weights[i].push_back(1 + abs(random_rational(random)));
          }
        const RationalPatch patch(points, weights);
        const SpacePolynomial f = random_equation(random, degree);
        const BivariatePolynomial g = pull_back(f, patch);
        CHECK(g.degree_r() == degree * m);
        CHECK(g.degree_s() == degree * n);
        const Rational u = random_rational(random, 5) / 7, v(3, 7);
        const HomogeneousPoint at = patch.homogeneous_at(u, v);
        if (at[3] != 0) CHECK(g(u, v) == power(at[3], degree) * f(patch(u, v)));
      }
}

TEST_CASE("without weights it is the composition, and on a surface itself zero") {
  Random random(26004);
  const BezierPatch patch = random_patch(random);
  const SpacePolynomial f = random_equation(random, 3);
  CHECK(pull_back(f, patch) == compose(f, patch));
  CHECK(pull_back(SpacePolynomial(), patch).is_zero());
  CHECK(pull_back(SpacePolynomial::constant(5), patch) == BivariatePolynomial::constant(5));
  // A quarter of a cylinder, by the weights 1, 1, 2 of a rational parametrisation.
  const RationalPatch quarter({{{1, 0, 0}, {1, 0, 3}}, {{1, 1, 0}, {1, 1, 3}}, {{0, 1, 0}, {0, 1, 3}}},
                              {{1, 1}, {1, 1}, {2, 2}});
  CHECK(pull_back(ImplicitSurface::cylinder({0, 0, 7}, {0, 0, -5}, 1).equation(), quarter).is_zero());
  CHECK_FALSE(pull_back(ImplicitSurface::cylinder({0, 0, 7}, {0, 0, -5}, 2).equation(), quarter).is_zero());
}

TEST_CASE("the pull back to a line is the value at its points") {
  const std::uint64_t seed = 26005;
  INFO("seed " << seed);
  Random random(seed);
  for (int degree = 1; degree <= 4; ++degree) {
    const SpacePolynomial f = random_equation(random, degree);
    const Point origin = random_point(random), direction = random_point(random);
    const Polynomial g = pull_back(f, origin, direction);
    for (const Rational& t : {Rational(0), Rational(-3, 7), Rational(100)})
      CHECK(g(t) == f(origin + t * direction));
    CHECK(pull_back(f, origin, Point{0, 0, 0}) == Polynomial(f(origin)));
  }
}

}  // namespace
}  // namespace exsect::surface_pull_back_test
