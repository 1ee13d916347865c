#include <exsect/algebra/descartes.h>

#include <stdexcept>

#include "algebra/random_numbers.h"
#include "algebra/root_checks.h"
#include "support/catch.h"

using namespace exsect;
using test::check_roots;
using test::with_roots;

TEST_CASE("isolate_roots: constants, linear, errors") {
  CHECK_THROWS_AS(isolate_roots(Polynomial(), 0, 1), std::domain_error);
  CHECK_THROWS_AS(isolate_roots(Polynomial({1, 1}), 1, 0), std::invalid_argument);
  CHECK(isolate_roots(Polynomial(3), 0, 1).empty());
  check_roots(Polynomial({-1, 3}), 0, 1, {Rational(1, 3)});
  check_roots(Polynomial({1, 3}), 0, 1, {});
  check_roots(Polynomial({0, 1}), 0, 1, {0});
  check_roots(Polynomial({-1, 1}), 0, 1, {1});
  check_roots(Polynomial({-1, 1}), 1, 1, {1});
  check_roots(Polynomial({-1, 1}), 2, 2, {});
}

TEST_CASE("isolate_roots: roots at ends and bisection points") {
  const std::vector<Rational> dyadic{0, Rational(1, 4), Rational(3, 8), Rational(1, 2), Rational(5, 8), 1};
  check_roots(with_roots(dyadic), 0, 1, dyadic);
  check_roots(-with_roots(dyadic), 0, 1, dyadic);
  // Neighbours of roots at bisection points, arbitrarily near.
  for (const long depth : {5L, 30L, 90L, 300L}) {
    std::vector<Rational> roots = dyadic;
    for (const Rational& root : dyadic)
      for (const int side : {-1, 1}) roots.push_back(root + side * power_of_two(-depth) / 3);
    INFO("depth " << depth);
    check_roots(with_roots(roots), 0, 1, test::inside(roots, 0, 1));
    // At the ends of the interval only.
    check_roots(with_roots({0, power_of_two(-depth), 1 - power_of_two(-depth), 1}), 0, 1,
                {0, power_of_two(-depth), 1 - power_of_two(-depth), 1});
  }
}

TEST_CASE("isolate_roots: any interval") {
  const std::vector<Rational> roots{-7, Rational(-5, 3), Rational(-1, 2), 0, Rational(22, 7), 100};
  for (const auto& [a, b] : std::vector<std::pair<Rational, Rational>>{{-7, 100},
                                                                       {-8, 101},
                                                                       {Rational(-5, 3), Rational(22, 7)},
                                                                       {-1, 0},
                                                                       {0, 3},
                                                                       {1, 2},
                                                                       {-7, -7},
                                                                       {-1000000, 3}})
    check_roots(with_roots(roots), a, b, test::inside(roots, a, b));
}

TEST_CASE("isolate_roots: multiple roots in the interval are found") {
  const Polynomial t = Polynomial::variable();
  const Polynomial rest = with_roots({Rational(1, 7), Rational(5, 6)});
  for (const Rational& root :
       {Rational(0), Rational(1), Rational(1, 2), Rational(3, 16), Rational(1, 3), Rational(2, 1000003)}) {
    INFO("root " << root);
    const Polynomial factor = test::linear_factor(root);
    CHECK_THROWS_AS(isolate_roots(factor * factor, 0, 1), std::invalid_argument);
    CHECK_THROWS_AS(isolate_roots(factor * factor * rest, 0, 1), std::invalid_argument);
    CHECK_THROWS_AS(isolate_roots(factor * factor * factor * rest, 0, 1), std::invalid_argument);
    CHECK_THROWS_AS(isolate_roots(factor * factor * rest, root, root), std::invalid_argument);
  }
  const Polynomial irrational = t * t - Polynomial(Rational(1, 2));
  CHECK_THROWS_AS(isolate_roots(irrational * irrational * rest, 0, 1), std::invalid_argument);
}

TEST_CASE("isolate_roots: multiple roots elsewhere do no harm") {
  const Polynomial t = Polynomial::variable();
  const Polynomial complex =
      (t - Polynomial(Rational(1, 3))) * (t - Polynomial(Rational(1, 3))) + Polynomial(power_of_two(-60));
  const Polynomial outside = test::linear_factor(1 + power_of_two(-70));
  const std::vector<Rational> roots{Rational(1, 3) + power_of_two(-50), Rational(2, 3)};
  check_roots(complex * complex * outside * outside * outside * with_roots(roots), 0, 1, roots);
}

TEST_CASE("isolate_roots: close roots") {
  for (const long gap : {10L, 60L, 120L, 250L, 1000L}) {
    const std::vector<Rational> roots{Rational(1, 3), Rational(1, 3) + power_of_two(-gap),
                                      Rational(1, 3) + 2 * power_of_two(-gap)};
    INFO("gap " << gap);
    check_roots(with_roots(roots), 0, 1, roots);
  }
}

TEST_CASE("isolate_roots: random roots") {
  const std::uint64_t seed = 20240341;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 60; ++i) {
    std::vector<Rational> roots;
    const int count = random.integer(0, 20);
    for (int k = 0; k < count; ++k) roots.push_back(random.rational(40, 1 + 8 * (i % 5)) / 32);
    roots = test::sorted(roots);
    const Polynomial f = with_roots(roots) * Polynomial({random.integer(1, 9), random.integer(-3, 3), 3});
    check_roots(f, 0, 1, test::inside(roots, 0, 1));
    const Rational a = random.rational(20, 12);
    check_roots(f, a, a + 1, test::inside(roots, a, a + 1));
  }
}
