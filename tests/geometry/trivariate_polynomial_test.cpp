#include <exsect/geometry/trivariate_polynomial.h>

#include "random_shapes.h"
#include "support/catch.h"

namespace exsect::trivariate_polynomial_test {

namespace {

TrivariatePolynomial random_trivariate(Random& random, std::size_t rows, std::size_t columns) {
  std::vector<std::vector<Polynomial>> coefficients(rows);
  for (auto& row : coefficients)
    for (std::size_t j = 0; j < columns; ++j)
      row.push_back(Polynomial({random_rational(random), random_rational(random), random_rational(random)}));
  return TrivariatePolynomial(coefficients);
}

}  // namespace

TEST_CASE("degrees are exact whatever zeros are given", "[trivariate_polynomial]") {
  const TrivariatePolynomial zero;
  CHECK(zero.is_zero());
  CHECK(zero.degree_u() == -1);
  CHECK(zero.degree_r() == -1);
  CHECK(zero.degree_s() == -1);
  CHECK(zero.derivative_r().is_zero());
  CHECK(zero.derivative_s().is_zero());
  CHECK((zero * zero).is_zero());
  CHECK(zero.at_u(3).is_zero());
  CHECK(zero.coefficient(0, 0).is_zero());
  CHECK(TrivariatePolynomial({{}, {}, {Polynomial(), Polynomial()}}) == zero);
  const Polynomial u = Polynomial::variable();
  const TrivariatePolynomial us({{Polynomial(), u, Polynomial()}, {Polynomial()}, {}});  // u s
  CHECK(us.degree_u() == 1);
  CHECK(us.degree_r() == 0);
  CHECK(us.degree_s() == 1);
  CHECK(us.coefficient(0, 1) == u);
  CHECK(us.coefficient(5, 0).is_zero());
  CHECK(us.coefficient(-1, 0).is_zero());
  CHECK(us.derivative_r().is_zero());
  CHECK(us.derivative_s() == TrivariatePolynomial({{u}}));
  CHECK((us - us).is_zero());
}

TEST_CASE("arithmetic commutes with setting u", "[trivariate_polynomial]") {
  const auto seed = 28u;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 10; ++round) {
    const TrivariatePolynomial a = random_trivariate(random, 1 + random() % 3, 1 + random() % 4);
    const TrivariatePolynomial b = random_trivariate(random, 1 + random() % 4, 1 + random() % 3);
    const Rational u = random_rational(random);
    CHECK((a * b).at_u(u) == a.at_u(u) * b.at_u(u));
    CHECK((a - b).at_u(u) == a.at_u(u) - b.at_u(u));
    CHECK(a.derivative_r().at_u(u) == a.at_u(u).derivative_r());
    CHECK(a.derivative_s().at_u(u) == a.at_u(u).derivative_s());
    CHECK(a * b == b * a);
  }
}

}  // namespace exsect::trivariate_polynomial_test
