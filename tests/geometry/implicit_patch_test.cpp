#include <exsect/geometry/implicit_patch.h>

#include <algorithm>

#include "geometry/random_shapes.h"
#include "support/catch.h"

namespace exsect::implicit_patch_test {
namespace {

const SpacePolynomial x = SpacePolynomial::variable(0);
const SpacePolynomial y = SpacePolynomial::variable(1);
const SpacePolynomial z = SpacePolynomial::variable(2);

/// x(u,v) = sum of the given vectors times u^i v^j, all others zero.
struct Term {
  std::size_t i, j;
  Point vector;
};
BezierPatch patch(const std::vector<Term>& terms) {
  ControlNet c;
  for (auto& row : c) row.fill({0, 0, 0});
  for (const Term& term : terms) c[term.i][term.j] = c[term.i][term.j] + term.vector;
  return BezierPatch::from_power_basis(c);
}

const Point ex = {1, 0, 0}, ey = {0, 1, 0}, ez = {0, 0, 1};

TEST_CASE("patches of low degree have equations of low degree") {
  CHECK(implicit_equation(patch({{1, 0, ex}, {0, 1, ey}})) == z);
  CHECK(implicit_equation(patch({{2, 0, ex}, {2, 0, ez}, {0, 1, ey}, {0, 0, {1, 2, 3}}})) ==
        (x - z + SpacePolynomial::constant(2)));
  CHECK(implicit_equation(patch({{1, 0, ex}, {0, 1, ey}, {1, 1, ez}})) == x * y - z);
  CHECK(implicit_equation(patch({{1, 0, ex}, {0, 1, ey}, {2, 2, ez}})) == x * x * y * y - z);
  // the parametrisation runs through the paraboloid twice
  CHECK(implicit_equation(patch({{2, 0, ex}, {0, 1, ey}, {2, 1, ez}})) == x * y - z);
  // Whitney's umbrella
  CHECK(implicit_equation(patch({{1, 1, ex}, {1, 0, ey}, {0, 2, ez}})) == y * y * z - x * x);
  CHECK(implicit_equation(patch({{1, 0, Rational(1, 7) * ex}, {0, 1, ey}, {2, 0, ez}})) ==
        Rational(49) * x * x - z);
}

TEST_CASE("curves and points have no implicit equation of a surface") {
  CHECK_THROWS_AS(implicit_equation(patch({})), std::domain_error);
  CHECK_THROWS_AS(implicit_equation(patch({{1, 0, ex}, {2, 0, ey}})), std::domain_error);
  // along the curve (t, t^2, 0) with t = u + v
  CHECK_THROWS_AS(
      implicit_equation(patch({{1, 0, ex}, {0, 1, ex}, {2, 0, ey}, {1, 1, Rational(2) * ey}, {0, 2, ey}})),
      std::domain_error);
  CHECK_THROWS_AS(vanishing_equations(patch({}), 0), std::invalid_argument);
  CHECK_THROWS_AS(vanishing_equations(patch({}), 9), std::invalid_argument);
}

TEST_CASE("random patches have degree 8, by two routes") {
  const std::uint64_t seed = 20260106;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 3; ++round) {
    const BezierPatch p = random_patch(random);
    const SpacePolynomial f = implicit_equation(p);
    CHECK(f.degree() == 8);
    CHECK(f.terms().size() == 165);
    CHECK(compose(f, p).is_zero());
    CHECK(f == f.primitive());
    CHECK(vanishing_equations(p, 7).empty());
    if (round == 0) CHECK(vanishing_equations(p, 8) == std::vector<SpacePolynomial>{f});
  }
}

TEST_CASE("the equation does not depend on the parametrisation") {
  const std::uint64_t seed = 20260107;
  INFO("seed " << seed);
  Random random(seed);
  const BezierPatch p = random_patch(random);
  const SpacePolynomial f = implicit_equation(p);
  CHECK(implicit_equation(p.exchanged()) == f);
  CHECK(implicit_equation(p.restricted_to(Rational(1, 3), Rational(1, 2), -1, 2)) == f);
}

TEST_CASE("base points of a patch lower its degree") {
  const std::uint64_t seed = 20260108;
  INFO("seed " << seed);
  Random random(seed);
  const auto with_zeros = [&](const std::vector<std::array<std::size_t, 2>>& zeros) {
    ControlNet c = random_net(random);
    for (const auto& [i, j] : zeros) c[i][j] = {0, 0, 0};
    return BezierPatch::from_power_basis(c);
  };
  const auto check = [](const BezierPatch& p, int degree) {
    const SpacePolynomial f = implicit_equation(p);
    CHECK(f.degree() == degree);
    CHECK(compose(f, p).is_zero());
    CHECK(vanishing_equations(p, degree).size() == 1);
    if (degree > 1) CHECK(vanishing_equations(p, degree - 1).empty());
  };
  check(with_zeros({{2, 2}}), 7);
  check(with_zeros({{2, 2}, {1, 2}}), 6);
  check(with_zeros({{2, 0}, {2, 1}, {2, 2}}), 4);                  // bidegree (1,2)
  check(with_zeros({{1, 1}, {1, 2}, {2, 1}, {2, 2}}), 4);          // translational
  check(with_zeros({{2, 0}, {2, 1}, {2, 2}, {0, 2}, {1, 2}}), 2);  // bilinear
}

TEST_CASE("affine substitution agrees with evaluation") {
  const std::uint64_t seed = 20260109;
  INFO("seed " << seed);
  Random random(seed);
  SpacePolynomial::Terms terms;
  for (const Exponents& e : exponents_up_to(4)) terms[e] = random_rational(random);
  const SpacePolynomial f(terms);
  const Point shift = random_point(random), scale = random_point(random);
  const SpacePolynomial g = affinely_substituted(f, shift, scale);
  for (int i = 0; i < 5; ++i) {
    const Point p = random_point(random);
    Point mapped;
    for (std::size_t k = 0; k < 3; ++k) mapped[k] = (p[k] - shift[k]) * scale[k];
    CHECK(g(p) == f(mapped));
  }
}

}  // namespace
}  // namespace exsect::implicit_patch_test
