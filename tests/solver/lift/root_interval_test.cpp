// Bounds of roots against the roots themselves.
#include "lift/root_interval.h"

#include <exsect/algebra/real_algebraic.h>

#include <random>

#include "support/catch.h"

namespace exsect::root_interval_test {
namespace {

const Polynomial t = Polynomial::variable();

Polynomial with_roots(const std::vector<Rational>& roots) {
  Polynomial f = 3;
  for (const Rational& root : roots) f *= t - Polynomial(root);
  return f;
}

}  // namespace

TEST_CASE("root interval: awkward polynomials") {
  CHECK(above_all_roots(Polynomial(7)) > 0);
  CHECK(above_all_roots(t * t * t) > 0);
  CHECK(above_all_roots(t * t - Polynomial(4)) > 2);
  CHECK(above_all_roots(t - Polynomial(power_of_two(100))) > power_of_two(100));
  CHECK(above_all_roots(t - Polynomial(power_of_two(-100))) > power_of_two(-100));
  CHECK(above_all_roots(t - Polynomial(power_of_two(-100))) < power_of_two(-96));
  // All terms of one size: the greatest root of t^n - t^(n-1) - ... - 1 tends to 2.
  Polynomial f = 1;
  for (int i = 0; i < 40; ++i) f *= t;
  for (int i = 0; i < 40; ++i) {
    Polynomial power = 1;
    for (int k = 0; k < i; ++k) power *= t;
    f -= power;
  }
  CHECK(above_all_roots(f) >= 2);
}

TEST_CASE("root interval: random roots") {
  const unsigned seed = 17;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> number(-1000, 1000), exponent(-30, 30), count(1, 8);
  for (int round = 0; round < 200; ++round) {
    std::vector<Rational> roots(static_cast<std::size_t>(count(random)));
    for (Rational& root : roots) root = Rational(number(random), 7) * power_of_two(exponent(random));
    const Polynomial f = with_roots(roots);
    const Rational bound = above_all_roots(f);
    Rational greatest = 0, least = roots[0], most = roots[0];
    for (const Rational& root : roots) {
      greatest = std::max<Rational>(greatest, abs(root));
      least = std::min(least, root);
      most = std::max(most, root);
    }
    CHECK(bound > greatest);
    // 2 m is at most twice the degree times the greatest root, and rounding makes that 4 times as much.
    CHECK((greatest == 0 || bound <= 8 * static_cast<int>(roots.size()) * greatest));
    const RationalInterval around = interval_around({f, Polynomial(5)}, {most + 1}, Rational(1, 3));
    CHECK(around.lower < least);
    CHECK(around.upper > most + 1);
    const RationalInterval fitted = fitted_interval({f});
    CHECK(fitted.lower < least);
    CHECK(fitted.upper > most);
    if (most - least > power_of_two(-60)) CHECK(fitted.width() <= 4096 * (most - least));
  }
  CHECK(fitted_interval({}).lower < 0);
  CHECK(fitted_interval({t * t + Polynomial(1)}).upper > 0);
}

}  // namespace exsect::root_interval_test
