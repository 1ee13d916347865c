// Forms of homogeneous coordinates on patches.
#include "special/space_form.h"

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::space_form_test {

TEST_CASE("space form: monomials in their order, and forms on patches") {
  const VectorPolynomial x = {BivariatePolynomial::constant(2), BivariatePolynomial::constant(3),
                              BivariatePolynomial::constant(5), BivariatePolynomial::constant(7)};
  std::vector<int> squares;
  for (const BivariatePolynomial& f : monomials(x, 2))
    squares.push_back(static_cast<int>(to_double(f.coefficient(0, 0))));
  CHECK(squares == std::vector<int>{4, 6, 10, 14, 9, 15, 21, 25, 35, 49});
  CHECK(monomials(x, 1).size() == 4);
  CHECK(monomials(x, 4).size() == 35);
  CHECK(on_patch({1, {1, 0, -2, 3}}, x) == BivariatePolynomial::constant(2 - 10 + 21));
  CHECK(on_patch({1, {0, 0, 0, 0}}, x).is_zero());
}

TEST_CASE("space form: relations are those of the surface") {
  // A saddle x y = z w.
  const RationalPatch saddle({{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 1}}});
  const VectorPolynomial y = components(saddle);
  CHECK(relations(monomials(y, 1)).empty());
  const auto quadrics = relations(monomials(y, 2));
  REQUIRE(quadrics.size() == 1);
  CHECK(quadrics[0][1] == -quadrics[0][8]);
  CHECK(on_patch({2, {quadrics[0].begin(), quadrics[0].end()}}, y).is_zero());
  CHECK(relations(monomials(y, 3)).size() == 4);
}

TEST_CASE("space form: Bernstein coefficients of two degrees more") {
  // 1, 0, 1 for the degree itself.
  const BivariatePolynomial r = BivariatePolynomial::r(), one = BivariatePolynomial::constant(1);
  const BivariatePolynomial f = (one - r) * (one - r) + r * r;
  const auto all_positive = [](const std::vector<Rational>& values) {
    return std::ranges::all_of(values, [](const Rational& c) { return c > 0; });
  };
  CHECK_FALSE(all_positive(bernstein_values(f, 2, 0)));
  CHECK(all_positive(bernstein_values(f)));
  CHECK(bernstein_values(f).size() == 5 * 3);
  CHECK_FALSE(all_positive(bernstein_values(f - BivariatePolynomial::constant(Rational(1, 2)))));
}

}  // namespace exsect::space_form_test
