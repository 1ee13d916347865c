#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/descartes.h>
#include <exsect/algebra/sturm.h>

#include <stdexcept>

#include "algebra/random_numbers.h"
#include "algebra/root_checks.h"
#include "support/catch.h"

namespace exsect::descartes_test {
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

TEST_CASE("isolate_roots: roots near the ends") {
  for (const long depth : {13L, 60L, 300L, 1500L}) {
    const Rational near = power_of_two(-depth);
    std::vector<Rational> small = {near / 3, near / 2, near * 2 / 3, near * 1000, near * near / 7};
    std::vector<Rational> roots = {Rational(1, 3), Rational(1, 2), Rational(4, 5)};
    for (const Rational& root : small) {
      roots.push_back(root);
      roots.push_back(1 - root);
    }
    INFO("depth " << depth);
    check_roots(with_roots(roots), 0, 1, test::sorted(roots));
    check_roots(with_roots(small), 0, 1, test::sorted(small));
    small.push_back(0);
    check_roots(with_roots(small), 0, 1, test::sorted(small));
    check_roots(with_roots(small).compose(Polynomial({Rational(1, 7), -1})), Rational(-6, 7), Rational(1, 7),
                [&] {
                  std::vector<Rational> turned;
                  for (const Rational& root : small) turned.push_back(Rational(1, 7) - root);
                  return test::sorted(turned);
                }());
    const Polynomial twice = test::linear_factor(near / 3) * test::linear_factor(near / 3);
    CHECK_THROWS_AS(isolate_roots(twice * with_roots({Rational(1, 3)}), 0, 1), std::invalid_argument);
  }
}

TEST_CASE("isolate_roots: random roots of all sizes") {
  const std::uint64_t seed = 20240344;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 100; ++i) {
    std::vector<Rational> roots;
    for (int k = random.integer(1, 12); k > 0; --k) {
      const Rational root = power_of_two(-random.integer(0, 10 << (i % 8))) * random.integer(1, 99) / 100;
      roots.push_back(random.integer(0, 1) == 0 ? root : 1 - root);
    }
    roots = test::sorted(roots);
    // Complex roots of all sizes.
    Polynomial f = with_roots(roots);
    for (int k = random.integer(0, 4); k > 0; --k)
      f *= Polynomial({power_of_two(-random.integer(0, 20 << (i % 8))),
                       random.integer(-1, 1) * power_of_two(-random.integer(10 << (i % 8), 11 << (i % 8))),
                       1});
    if (!is_squarefree(f)) continue;
    INFO("case " << i);
    test::check_isolating(f, 0, 1, isolate_roots(f, 0, 1));
    CHECK(static_cast<int>(isolate_roots(f, 0, 1).size()) == SturmSequence(f).count_closed(0, 1));
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

TEST_CASE("isolate_roots: degree 128 with known roots") {
  std::vector<Rational> even;
  for (int k = 1; k <= 128; ++k) even.push_back(Rational(k, 129));
  check_roots(with_roots(even), 0, 1, even);
  check_roots(with_roots(even), Rational(5, 129), Rational(1, 2),
              test::inside(even, Rational(5, 129), Rational(1, 2)));

  const std::uint64_t seed = 20240342;
  INFO("seed " << seed);
  test::Random random(seed);
  std::vector<Rational> roots{0, Rational(1, 2), Rational(3, 7), Rational(3, 7) + power_of_two(-70), 1};
  for (int k = 0; k < 20; ++k) roots.push_back(Rational(abs(random.big_integer(53)), Integer(1) << 53));
  // Complex roots close to the interval, and real ones outside.
  Polynomial f = with_roots(roots);
  while (f.degree() < 120) {
    const Rational re = random.rational(40, 7) / 20;
    f *= Polynomial({re * re + power_of_two(-random.integer(2, 20)), -2 * re, 1});
  }
  while (f.degree() < 128) f *= Polynomial({-2 - f.degree(), 1});
  check_roots(f, 0, 1, test::sorted(roots));
}

TEST_CASE("isolate_roots: parts, mirror image and scaling have the same roots") {
  const std::uint64_t seed = 20240343;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 40; ++i) {
    const int degree = i < 36 ? random.integer(1, 40) : 128;
    const Polynomial f = from_bernstein(random.big_polynomial(degree, 20 + 60 * (i % 6)).coefficients());
    if (f.degree() < 1 || !is_squarefree(f)) continue;
    INFO("case " << i);
    const std::vector<IsolatingInterval> all = isolate_roots(f, 0, 1);
    test::check_isolating(f, 0, 1, all);
    const Rational middle = i % 2 == 0 ? Rational(1, 2) : Rational(random.integer(1, 99), 100);
    const std::vector<IsolatingInterval> first = isolate_roots(f, 0, middle);
    const std::vector<IsolatingInterval> second = isolate_roots(f, middle, 1);
    test::check_isolating(f, middle, 1, second);
    const std::size_t shared = f.sign_at(middle) == 0 ? 1 : 0;
    CHECK(first.size() + second.size() == all.size() + shared);
    const Polynomial mirror = f.compose(Polynomial({1, -1}));
    CHECK(isolate_roots(mirror, 0, 1).size() == all.size());
    CHECK(isolate_roots(-f, 0, 1).size() == all.size());
    const Polynomial stretched = f.compose(Polynomial({Rational(-3, 7), Rational(1, 7)}));
    CHECK(isolate_roots(stretched, 3, 10).size() == all.size());
  }
}

}  // namespace exsect::descartes_test
