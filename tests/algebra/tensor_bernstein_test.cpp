#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/tensor_bernstein.h>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::tensor_bernstein_test {
namespace {

const BivariatePolynomial r = BivariatePolynomial::r();
const BivariatePolynomial s = BivariatePolynomial::s();

TEST_CASE("tensor Bernstein coefficients of simple polynomials") {
  CHECK(tensor_bernstein({}, 0, 1) == std::vector<std::vector<Rational>>{{0, 0}});
  CHECK(tensor_bernstein(r, 1, 0, {{2, 5}, {0, 1}}) == std::vector<std::vector<Rational>>{{2}, {5}});
  CHECK(tensor_bernstein(r * s, 1, 1) == std::vector<std::vector<Rational>>{{0, 0}, {0, 1}});
  CHECK_THROWS_AS(tensor_bernstein(r, 0, 0), std::invalid_argument);
  CHECK_THROWS_AS(tensor_bernstein(s, 0, 0), std::invalid_argument);
  CHECK_THROWS_AS(tensor_bernstein(s, -1, 1), std::invalid_argument);
  CHECK_THROWS_AS(tensor_bernstein(s, 0, 1, {{0, 1}, {1, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(range_bound(s, {}, -1), std::invalid_argument);
  CHECK_THROWS_AS(range_bound(s, {}, 11), std::invalid_argument);
}

TEST_CASE("tensor Bernstein coefficients give the polynomial back and bound it") {
  const std::uint64_t seed = 20260104;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int round = 0; round < 20; ++round) {
    std::vector<Polynomial> rows;
    for (int i = 0; i < 4; ++i) rows.push_back(random.polynomial(3, 9, 5));
    const BivariatePolynomial f(rows);
    const Rectangle on = {{Rational(-1, 3), Rational(round + 1, 2)}, {Rational(1, 7), 2}};
    const auto b = tensor_bernstein(f, 4, 3, on);
    const RationalInterval coarse = range_bound(f, on), fine = range_bound(f, on, 3);
    CHECK(coarse.lower <= fine.lower);
    CHECK(fine.upper <= coarse.upper);
    for (int i = 0; i <= 5; ++i)
      for (int j = 0; j <= 5; ++j) {
        const Rational t(i, 5), w(j, 5);
        Rational value = 0;
        for (int k = 0; k <= 4; ++k)
          for (int l = 0; l <= 3; ++l) {
            const std::vector<Rational> in_t = [&] {
              std::vector<Rational> unit(5);
              unit[static_cast<std::size_t>(k)] = 1;
              return unit;
            }();
            std::vector<Rational> in_w(4);
            in_w[static_cast<std::size_t>(l)] = 1;
            value += b[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)] * from_bernstein(in_t)(t) *
                     from_bernstein(in_w)(w);
          }
        const Rational exact = f(on.r.lower + t * on.r.width(), on.s.lower + w * on.s.width());
        CHECK(value == exact);
        CHECK((fine.lower <= exact && exact <= fine.upper));
      }
  }
}

}  // namespace
}  // namespace exsect::tensor_bernstein_test
