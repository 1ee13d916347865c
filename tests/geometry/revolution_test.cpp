#include <exsect/geometry/revolution.h>

#include "geometry/random_shapes.h"
#include "support/catch.h"

namespace exsect::revolution_test {
namespace {

const BivariatePolynomial r = BivariatePolynomial::r();
const BivariatePolynomial z = BivariatePolynomial::s();
BivariatePolynomial number(const Rational& q) { return BivariatePolynomial::constant(q); }

BivariatePolynomial random_profile(Random& random, int degree_r, int degree_z) {
  std::vector<Polynomial> rows;
  for (int i = 0; i <= degree_r; ++i) {
    std::vector<Rational> row;
    for (int j = 0; j <= degree_z; ++j) row.push_back(random_rational(random));
    rows.emplace_back(row);
  }
  return BivariatePolynomial(rows);
}

TEST_CASE("profiles without r, without even and without odd powers") {
  CHECK(revolved_by_product({}).is_zero());
  CHECK(revolved_by_elimination({}).is_zero());
  for (const BivariatePolynomial& f : {number(3), z - number(1), r, r * r - z, r * r * r + r * z}) {
    CHECK(revolved_by_product(f) == revolved_by_elimination(f));
  }
  CHECK(revolved_by_product(r) == number(-1) * r);
  CHECK(revolved_by_substitution(r * r - z) == r - z);
  CHECK_THROWS_AS(revolved_by_substitution(r * r - r), std::invalid_argument);
}

TEST_CASE("the torus") {
  // (r - 2)^2 + z^2 = 1
  const BivariatePolynomial f = r * r - number(4) * r + number(3) + z * z;
  const BivariatePolynomial g = revolved_by_product(f);
  const BivariatePolynomial square = r + z * z + number(3);
  CHECK(g == square * square - number(16) * r);
  CHECK(revolved_by_elimination(f) == g);
  const SpacePolynomial torus = surface_of_revolution(g);
  CHECK(torus.degree() == 4);
  CHECK(torus({0, 3, 0}) == 0);
  CHECK(torus({1, 0, 0}) == 0);
  CHECK(torus({Rational(6, 5), Rational(8, 5), 1}) == 0);
  CHECK(torus({1, 1, 1}) != 0);
}

TEST_CASE("elimination and product agree, sign included, and vanish on both sheets") {
  const std::uint64_t seed = 20260111;
  INFO("seed " << seed);
  Random random(seed);
  for (int degree_r = 0; degree_r <= 5; ++degree_r)
    for (int degree_z = 0; degree_z <= 4; degree_z += 2) {
      const BivariatePolynomial f = random_profile(random, degree_r, degree_z);
      const BivariatePolynomial g = revolved_by_product(f);
      CHECK(g == revolved_by_elimination(f));
      const Rational radius = random_rational(random), height = random_rational(random);
      CHECK(g(radius * radius, height) == f(radius, height) * f(-radius, height));
    }
}

TEST_CASE("the revolved biquartic has degrees (8,8,8)") {
  const std::uint64_t seed = 20260112;
  INFO("seed " << seed);
  Random random(seed);
  const SpacePolynomial g = surface_of_revolution(revolved_by_product(random_profile(random, 4, 4)));
  for (std::size_t axis = 0; axis < 3; ++axis) CHECK(g.degree_in(axis) == 8);
  for (const auto& [e, c] : g.terms()) CHECK((e[0] % 2 == 0 && e[1] % 2 == 0));
}

TEST_CASE("substitution of total degree 3 has degrees (6,6,3)") {
  const std::uint64_t seed = 20260113;
  INFO("seed " << seed);
  Random random(seed);
  BivariatePolynomial f;  // total degree 3 in (r^2, z)
  for (int i = 0; i <= 3; ++i) {
    BivariatePolynomial power = number(1);
    for (int k = 0; k < i; ++k) power = power * r * r;
    for (int j = 0; i + j <= 3; ++j, power = power * z) f += power * Polynomial(random_rational(random));
  }
  CHECK(f.degree_r() == 6);
  CHECK(f.degree_s() == 3);
  const BivariatePolynomial g = revolved_by_substitution(f);
  const SpacePolynomial surface = surface_of_revolution(g);
  CHECK(surface.degree_in(0) == 6);
  CHECK(surface.degree_in(1) == 6);
  CHECK(surface.degree_in(2) == 3);
  const Rational x(3, 5), y(4, 5);  // r = 1
  CHECK(surface({x, y, Rational(1, 7)}) == f(1, Rational(1, 7)));
}

TEST_CASE("elimination segment by segment tears a smooth spline profile") {
  // z = r for r <= 1 and z = r + (r-1)^2 for r >= 1: the products agree at (1,1) but for the gradient's sign.
  const BivariatePolynomial lower = z - r;
  const BivariatePolynomial upper = z - r - (r - number(1)) * (r - number(1));
  const auto gradient = [&](const BivariatePolynomial& f) {
    // of g(r^2, z) in (r, z) at (1,1)
    const BivariatePolynomial g = revolved_by_product(f);
    CHECK(g(1, 1) == 0);
    return std::array<Rational, 2>{2 * g.derivative_r()(1, 1), g.derivative_s()(1, 1)};
  };
  CHECK(lower(1, 1) == upper(1, 1));
  CHECK(gradient(lower) == std::array<Rational, 2>{-2, 2});
  CHECK(gradient(upper) == std::array<Rational, 2>{2, -2});
}

TEST_CASE("the equation on a patch, with and without expanding it") {
  const std::uint64_t seed = 20260114;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 4; ++round) {
    const BivariatePolynomial g = revolved_by_product(random_profile(random, round, 2));
    const BezierPatch patch = random_patch(random);
    CHECK(compose_revolution(g, patch) == compose(surface_of_revolution(g), patch));
  }
}

TEST_CASE("the sign of even times odd tells the sheets apart") {
  // f = r - 2 has the sheet r = 2 on R = 4, its mirrored copy r = -2 is the own sheet of r + 2
  const ParityParts own = parity_parts(r - number(2)), other = parity_parts(r + number(2));
  CHECK(sheet_of_sign(sign((own.even * own.odd)(4, 0))) == Sheet::own);
  CHECK(sheet_of_sign(sign((other.even * other.odd)(4, 0))) == Sheet::mirrored);
  CHECK(sheet_of_sign(0) == Sheet::both);
}

}  // namespace
}  // namespace exsect::revolution_test
