#include "curve/turning_resultant.h"

#include <exsect/algebra/determinant.h>
#include <exsect/algebra/resultant.h>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::turning_resultant_test {
namespace {

const BivariatePolynomial u = BivariatePolynomial::r();
const BivariatePolynomial v = BivariatePolynomial::s();

TEST_CASE("turning resultants of simple curves") {
  CHECK_THROWS_AS(turning_resultant({}), std::domain_error);
  CHECK(turning_resultant(u * u) == Polynomial(1));
  CHECK(turning_resultant((u - v) * (u - v)).is_zero());
  // v^2 - u: the resultant with 2 v is -4 u
  CHECK(turning_resultant(v * v - u) == Polynomial({0, -4}));
}

TEST_CASE("turning resultants agree with the multivariate resultant") {
  const std::uint64_t seed = 20260116;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int round = 0; round < 12; ++round) {
    std::vector<Polynomial> rows;
    for (int i = 0; i <= round % 4 + 1; ++i) rows.push_back(random.polynomial(round % 3 + 1, 50, 6));
    const BivariatePolynomial f(rows);
    if (f.degree_s() < 1) continue;
    CHECK(turning_resultant(f) == resultant_s(primitive(f), primitive(f).derivative_s()));
  }
}

}  // namespace
}  // namespace exsect::turning_resultant_test
