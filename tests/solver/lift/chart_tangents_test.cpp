#include "lift/chart_tangents.h"

#include <random>

#include "support/catch.h"

namespace exsect::chart_tangents_test {

TEST_CASE("polynomials over rectangles contain their exact values", "[lift]") {
  const unsigned seed = 8;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int k = 0; k < 300; ++k) {
    const int m = k % 5, n = k / 5 % 6;
    BivariatePolynomial f, power_u = BivariatePolynomial::constant(1);
    for (int i = 0; i <= m; ++i) {
      BivariatePolynomial power = power_u;
      for (int j = 0; j <= n; ++j) {
        f += power * BivariatePolynomial::constant(from_double(number(generator)) / 3);
        power = power * BivariatePolynomial::s();
      }
      power_u = power_u * BivariatePolynomial::r();
    }
    const double u = 2 * number(generator), v = 2 * number(generator);
    const double reach = k % 3 == 0 ? 0 : k % 3 == 1 ? 0x1p-10 : 0.25;
    const RationalInterval all =
        EnclosedPolynomial(f, Rational(1, 7)).over(DoubleBall(u, reach), DoubleBall(v, reach)).interval();
    for (const double a : {-reach, reach * 0.3, reach})
      for (const double b : {-reach, reach * 0.7, reach}) {
        const Rational value = 7 * f(from_double(u) + from_double(a), from_double(v) + from_double(b));
        CHECK(all.lower <= value);
        CHECK(value <= all.upper);
      }
    if (reach < 0.1) CHECK(to_double(all.width()) < 1e5 * reach + 1e-9);
  }
}

TEST_CASE("polynomials over rectangles: cancellation and overflow prove nothing", "[lift]") {
  // (r - 1/3)^8 takes values below the errors of doubles about 1/3.
  BivariatePolynomial power = BivariatePolynomial::constant(1);
  for (int k = 0; k < 8; ++k)
    power = power * (BivariatePolynomial::r() - BivariatePolynomial::constant(Rational(1, 3)));
  CHECK(EnclosedPolynomial(power, 1).over(0.34, 0.0).certain_sign() == 0);
  CHECK(EnclosedPolynomial(power, 1).over(0.9, 0.0).is_positive());
  const DoubleBall beyond = EnclosedPolynomial(power, 1).over(1e100, 0.0);
  CHECK(beyond.certain_sign() == 0);
  CHECK(beyond.lower_magnitude() == 0);
}

}  // namespace exsect::chart_tangents_test
