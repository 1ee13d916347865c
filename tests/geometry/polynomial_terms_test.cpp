#include <exsect/geometry/polynomial_terms.h>

#include "support/catch.h"

namespace exsect::polynomial_terms_test {

TEST_CASE("polynomials print as computer algebra systems read them", "[polynomial_terms]") {
  const BivariatePolynomial x = BivariatePolynomial::r(), y = BivariatePolynomial::s();
  const auto text = [](const BivariatePolynomial& f) { return to_text(terms_of(f, "x", "y")); };
  const auto c = [](const Rational& q) { return BivariatePolynomial::constant(q); };
  CHECK(text({}) == "0");
  CHECK(text(c(-1)) == "-1");
  CHECK(text(c(Rational(3, 7))) == "3/7");
  CHECK(text(x) == "x");
  CHECK(text(c(0) - y) == "-y");
  CHECK(text(c(4) * x * x + c(8) * y * y - c(1)) == "4*x^2+8*y^2-1");
  CHECK(text(c(Rational(-3, 7)) * x * y + y * y * y - x) == "y^3-3/7*x*y-x");
}

TEST_CASE("terms are sorted by total degree, the first variable first", "[polynomial_terms]") {
  const SpacePolynomial f({{{2, 0, 0}, 2}, {{1, 1, 0}, 1}, {{0, 0, 1}, 3}, {{0, 0, 0}, 1}});
  const PolynomialTerms list = terms_of(f);
  CHECK(to_text(list) == "2*x^2+x*y+3*z+1");
  CHECK(list.total_degree() == 2);
  CHECK(list.degrees() == std::vector<int>{2, 1, 1});
  const PolynomialTerms zero = terms_of(SpacePolynomial());
  CHECK(zero.total_degree() == -1);
  CHECK(zero.degrees() == std::vector<int>{-1, -1, -1});
}

}  // namespace exsect::polynomial_terms_test
