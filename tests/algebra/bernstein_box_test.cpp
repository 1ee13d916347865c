#include <exsect/algebra/bernstein_box.h>

#include "random_numbers.h"
#include "support/catch.h"

namespace exsect::bernstein_box_test {
using exsect::test::Random;

TEST_CASE("Bernstein boxes of special polynomials", "[bernstein_box]") {
  const BivariatePolynomial r = BivariatePolynomial::r(), s = BivariatePolynomial::s();
  const RationalInterval unit = {0, 1};
  CHECK(BernsteinBox({}, unit, unit).sign() == 0);
  CHECK(BernsteinBox({}, unit, unit).upper() == 0);
  CHECK(BernsteinBox(BivariatePolynomial::constant(-3), unit, unit).sign() == -1);
  CHECK(BernsteinBox(r, unit, unit).sign() == 0);
  CHECK(BernsteinBox(r + s, {1, 2}, {-1, 3}).lower() == 0);
  CHECK(BernsteinBox(r + s, {1, 2}, {-1, 3}).upper() == 5);
  // r^2 - r + 1/3 > 0: seen after one division only.
  const BivariatePolynomial f = r * r - r + BivariatePolynomial::constant(Rational(1, 3));
  const BernsteinBox whole(f, unit, unit);
  CHECK(whole.sign() == 0);
  CHECK(whole.split_r().first.sign() == 1);
  CHECK(whole.split_r().second.sign() == 1);
  CHECK(whole.split_s().first.sign() == 0);
  CHECK_THROWS_AS(BernsteinBox(f, {1, 1}, unit), std::invalid_argument);
}

TEST_CASE("divided boxes have the coefficients of the parts", "[bernstein_box]") {
  const auto seed = 61u;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 20; ++round) {
    std::vector<Polynomial> rows;
    for (int i = 0; i <= random.integer(0, 4); ++i)
      rows.push_back(random.polynomial(random.integer(0, 4), 9, 4));
    const BivariatePolynomial f(rows);
    const RationalInterval r = {Rational(-1, 3), Rational(random.integer(1, 9), 2)};
    const RationalInterval s = {Rational(random.integer(-9, 0), 5), Rational(2, 7)};
    const auto same = [&](const BernsteinBox& a, const RationalInterval& in_r, const RationalInterval& in_s) {
      const BernsteinBox b(f, in_r, in_s);
      CHECK(a.lower() == b.lower());
      CHECK(a.upper() == b.upper());
      CHECK(a.sign() == b.sign());
      const Rational middle = f(in_r.midpoint(), in_s.midpoint());
      CHECK(a.lower() <= middle);
      CHECK(a.upper() >= middle);
      for (const bool upper_r : {false, true})
        for (const bool upper_s : {false, true})
          CHECK(a.sign_at_corner(upper_r, upper_s) ==
                f(upper_r ? in_r.upper : in_r.lower, upper_s ? in_s.upper : in_s.lower).sign());
    };
    const BernsteinBox whole(f, r, s);
    same(whole, r, s);
    same(whole.split_r().first, {r.lower, r.midpoint()}, s);
    same(whole.split_r().second, {r.midpoint(), r.upper}, s);
    same(whole.split_s().first, r, {s.lower, s.midpoint()});
    same(whole.split_r().second.split_s().second, {r.midpoint(), r.upper}, {s.midpoint(), s.upper});
  }
}

}  // namespace exsect::bernstein_box_test
