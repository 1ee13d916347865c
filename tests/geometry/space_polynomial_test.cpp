#include <exsect/geometry/space_polynomial.h>

#include <random>
#include <set>

#include "geometry/random_shapes.h"
#include "support/catch.h"

namespace exsect::space_polynomial_test {
namespace {

const SpacePolynomial x = SpacePolynomial::variable(0);
const SpacePolynomial y = SpacePolynomial::variable(1);
const SpacePolynomial z = SpacePolynomial::variable(2);

TEST_CASE("the zero polynomial in space") {
  const SpacePolynomial zero = x - x;
  CHECK(zero.is_zero());
  CHECK(zero == SpacePolynomial());
  CHECK(zero.degree() == -1);
  CHECK(zero.degree_in(1) == -1);
  CHECK(zero.primitive().is_zero());
  CHECK(zero({1, 2, 3}) == 0);
  CHECK((Rational(0) * x).is_zero());
  CHECK((x * zero).is_zero());
  CHECK(exponents_up_to(-1).empty());
  CHECK_THROWS_AS(SpacePolynomial({{{0, -1, 0}, 1}}), std::invalid_argument);
}

TEST_CASE("arithmetic and degrees of polynomials in space") {
  const SpacePolynomial f = Rational(1, 2) * x * x * z - Rational(3, 4) * y + SpacePolynomial::constant(-1);
  CHECK(f.degree() == 3);
  CHECK(f.degree_in(0) == 2);
  CHECK(f({2, 1, 3}) == Rational(6) - Rational(7, 4));
  CHECK(f.derivative(0) == x * z);
  CHECK(f.derivative(2) == Rational(1, 2) * x * x);
  CHECK((Rational(-1) * f).primitive() == Rational(4) * f);
  CHECK((Rational(-1) * y * y + z).primitive() == y * y - z);
  SpacePolynomial twice = f;
  twice += twice;
  CHECK(twice == Rational(2) * f);
  twice -= twice;
  CHECK(twice.is_zero());
}

TEST_CASE("the exponents up to a degree are all different and as many as there must be") {
  for (int d = 0; d <= 8; ++d) {
    const std::vector<Exponents> all = exponents_up_to(d);
    CHECK(all.size() == static_cast<std::size_t>((d + 1) * (d + 2) * (d + 3) / 6));
    CHECK(std::set<Exponents>(all.begin(), all.end()).size() == all.size());
  }
}

TEST_CASE("composition with a patch agrees with evaluation") {
  const std::uint64_t seed = 20260103;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<int> number(-5, 5);
  for (int round = 0; round < 5; ++round) {
    SpacePolynomial::Terms terms;
    for (const Exponents& e : exponents_up_to(3))
      if (number(random) > 0) terms[e] = Rational(number(random), 3);
    const SpacePolynomial f(terms);
    const BezierPatch patch = random_patch(random);
    const BivariatePolynomial composed = compose(f, patch);
    CHECK(composed.degree_r() <= 6);
    CHECK(composed.degree_s() <= 6);
    for (int i = 0; i < 10; ++i) {
      const Rational u(number(random), 3), v(number(random), 7);
      CHECK(composed(u, v) == f(patch(u, v)));
    }
  }
  CHECK(compose(SpacePolynomial(), random_patch(random)).is_zero());
}

}  // namespace
}  // namespace exsect::space_polynomial_test
