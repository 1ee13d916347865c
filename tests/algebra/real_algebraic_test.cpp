#include <exsect/algebra/real_algebraic.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "algebra/algebraic_specimens.h"
#include "support/catch.h"

namespace exsect::real_algebraic_test {
using namespace exsect::test;

namespace {

const Polynomial t = Polynomial::variable();

/// What the type promises, from its public face alone.
void check_invariant(const RealAlgebraic& x) {
  const RationalInterval interval = x.interval();
  const Polynomial& f = x.polynomial();
  CHECK(f == f.primitive());
  CHECK(f.degree() >= 1);
  if (x.is_rational()) {
    CHECK(interval.lower == interval.upper);
    CHECK(x.rational() == interval.lower);
    CHECK(f.degree() == 1);
    CHECK(f.sign_at(x.rational()) == 0);
  } else {
    CHECK(interval.lower < interval.upper);
    CHECK(f.sign_at(interval.lower) * f.sign_at(interval.upper) == -1);
  }
}

void check_refinement(const RealAlgebraic& x, const Rational& width) {
  const RealAlgebraic refined = x.refined_to(width);
  check_invariant(refined);
  CHECK(refined.interval().width() <= width);
  CHECK(refined.interval().lower >= x.interval().lower);
  CHECK(refined.interval().upper <= x.interval().upper);
  CHECK(refined == x);
}

RealAlgebraic only_root(const Polynomial& f, const Rational& a, const Rational& b) {
  const std::vector<RealAlgebraic> roots = real_roots(f, a, b);
  REQUIRE(roots.size() == 1);
  return roots.front();
}

/// Numbers of every kind, several of them given twice in different ways.
std::vector<RealAlgebraic> specimens() {
  const Polynomial two = t * t - Polynomial(2);
  const Rational tiny = Rational(1, pow(Integer(10), 40));
  std::vector<RealAlgebraic> all = {
      0, 1, Rational(-3, 7), Rational(1, 2), power_of_two(200), power_of_two(-200),
      // the same rationals, not known to be rational
      RealAlgebraic::root_of(t * two, {-1, Rational(4, 3)}),
      RealAlgebraic::root_of((t + t - Polynomial(1)) * (t * t - Polynomial(5)),
                             {Rational(1, 3), Rational(4, 7)}),
      RealAlgebraic::root_of((t * Rational(7) + Polynomial(3)) * two, {-1, 0}),
      // sqrt 2 three times, and its conjugate
      RealAlgebraic::root_of(two, {1, 2}),
      RealAlgebraic::root_of(-two * (t * t - Polynomial(3)), {1, Rational(3, 2)}),
      RealAlgebraic::root_of(two * linear_factor(5), {Rational(-1, 3), 4}),
      RealAlgebraic::root_of(two, {-2, 1}),
      // a convergent of sqrt 2
      Rational(Integer("1572584048032918633353217"), Integer("1111984844349868137938112"))};
  for (const Polynomial& f :
       {two * two - Polynomial(tiny), t * t * t - t * Rational(3) + Polynomial(1),
        t * t * Rational(Integer(1) << 300) - Polynomial(1), linear_factor(1) * two * two})
    for (const RealAlgebraic& root : real_roots(f, -3, 3)) all.push_back(root);
  return all;
}

}  // namespace

TEST_CASE("real algebraic: rationals") {
  const RealAlgebraic x = Rational(-3, 7);
  check_invariant(x);
  CHECK(x.polynomial() == t * Rational(7) + Polynomial(3));
  CHECK(x.to_double() == -3.0 / 7);
  CHECK(x.refined_to(power_of_two(-100)).rational() == Rational(-3, 7));
  CHECK(x.compare(Rational(-3, 7)) == 0);
  CHECK(x.compare(-1) == 1);
  CHECK(x.compare(0) == -1);
  CHECK(sign_at(t * Rational(7) + Polynomial(3), x) == 0);
  CHECK(sign_at(Polynomial(), x) == 0);
}

TEST_CASE("real algebraic: preconditions are refused") {
  const Polynomial two = t * t - Polynomial(2);
  CHECK_THROWS_AS(RealAlgebraic::root_of(two, {2, 3}), std::invalid_argument);
  CHECK_THROWS_AS(RealAlgebraic::root_of(two, {2, 1}), std::invalid_argument);
  CHECK_THROWS_AS(RealAlgebraic::root_of(two, {1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(RealAlgebraic::root_of(t, {0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(RealAlgebraic::root_of(Polynomial(), {0, 1}), std::invalid_argument);
  const RealAlgebraic x = RealAlgebraic::root_of(two, {1, 2});
  CHECK_THROWS_AS(x.refined_to(0), std::invalid_argument);
  CHECK_THROWS_AS(x.refined_to(-1), std::invalid_argument);
  CHECK_THROWS_AS(x.rational(), std::domain_error);
  CHECK_THROWS_AS(real_roots(Polynomial(), 0, 1), std::domain_error);
  CHECK_THROWS_AS(real_roots(two, 1, 0), std::invalid_argument);
}

TEST_CASE("real algebraic: a linear polynomial gives a rational") {
  CHECK(RealAlgebraic::root_of(t * Rational(3) - Polynomial(1), {0, 1}).rational() == Rational(1, 3));
  CHECK(only_root(t * Rational(-6) + Polynomial(2), 0, 1).rational() == Rational(1, 3));
}

TEST_CASE("real algebraic: refinement against integer square roots") {
  const RationalInterval start{1, Rational(3, 2)};
  const RealAlgebraic x = RealAlgebraic::root_of(t * t - Polynomial(2), start);
  for (const long bits : {0L, 1L, 2L, 3L, 10L, 52L, 60L, 200L, 1000L, 3001L}) {
    const RationalInterval interval = x.refined_to(power_of_two(-bits)).interval();
    CHECK(interval.width() <= power_of_two(-bits));
    CHECK(interval.lower * interval.lower < 2);
    CHECK(interval.upper * interval.upper > 2);
    const Integer floor_root = sqrt(Integer(2) << static_cast<unsigned>(2 * bits));
    const Rational below = Rational(floor_root) * power_of_two(-bits);
    CHECK(interval.upper > below);
    CHECK(interval.lower < below + power_of_two(-bits));
  }
  for (const Rational& width : {Rational(1, 3), Rational(1, 1000), Rational(3, pow(Integer(10), 100))})
    check_refinement(x, width);
}

TEST_CASE("real algebraic: refinement from awkward intervals") {
  const Polynomial two = t * t - Polynomial(2);
  const Rational close =
      Rational(sqrt(Integer(2) << 400), Integer(1) << 200);  // sqrt 2 - 2^-200 < close < sqrt 2
  for (const RationalInterval& start :
       {RationalInterval{close, 2}, RationalInterval{0, close + power_of_two(-200)},
        RationalInterval{Rational(1, 3), 2}, RationalInterval{Rational(-1, 3), power_of_two(100)},
        RationalInterval{close, close + power_of_two(-200)},
        RationalInterval{close - Rational(1, 3), close + Rational(1, 3)}}) {
    const RealAlgebraic x = RealAlgebraic::root_of(two, start);
    for (const long bits : {5L, 60L, 190L, 700L}) check_refinement(x, power_of_two(-bits));
  }
  // large numbers: exponents below zero
  const RealAlgebraic large =
      RealAlgebraic::root_of(t * t * t - Polynomial(power_of_two(500)), {1, power_of_two(400)});
  for (const long bits : {-160L, -100L, 0L, 100L}) check_refinement(large, power_of_two(-bits));
  // dyadic and other rational roots of polynomials that are not linear
  const RealAlgebraic half = RealAlgebraic::root_of(two * (t * Rational(2) - Polynomial(1)), {0, 1});
  CHECK(half.refined_to(power_of_two(-10)).rational() == Rational(1, 2));
  const RealAlgebraic third = RealAlgebraic::root_of(two * (t * Rational(3) - Polynomial(1)), {0, 1});
  for (const long bits : {5L, 60L, 700L}) check_refinement(third, power_of_two(-bits));
}

TEST_CASE("real algebraic: refinement at all scales, either sign, against integer square roots") {
  const std::uint64_t seed = 20250708;
  INFO("seed " << seed);
  Random random(seed);
  for (const int scale : {-300, -64, -5, 0, 5, 63, 64, 300})
    for (const Polynomial& multiple : {Polynomial(1), Polynomial(-7), random.big_polynomial(9, 400)}) {
      const Rational unit = power_of_two(scale);
      const QuadraticNumber x{random.rational(5, 7) * unit, (random.integer(0, 1) * 2 - 1) * unit / 3,
                              random.integer(2, 3)};
      const RealAlgebraic number = x.number(multiple, 400);
      for (const long bits : {401L, 450L, 1000L}) {
        const RationalInterval refined = number.refined_to(unit * power_of_two(-bits)).interval();
        const RationalInterval expected = x.enclosure(1200);
        CHECK(refined.width() <= unit * power_of_two(-bits));
        CHECK(refined.lower < expected.upper);
        CHECK(refined.upper > expected.lower);
      }
      check_refinement(number, unit * power_of_two(-500));
    }
}

TEST_CASE("real algebraic: refinement where doubling fails often") {
  // Next to t = 0 the curve t^32 - 2^-k (1 + t) is flat: secants are bad for a long time.
  for (const long k : {3L, 64L, 500L}) {
    Polynomial power = 1;
    for (int i = 0; i < 32; ++i) power *= t;
    const Polynomial f = power - (t + Polynomial(1)) * Polynomial(power_of_two(-k));
    const RealAlgebraic root = only_root(f, 0, 2);
    for (const long bits : {10L, 100L, 1000L}) check_refinement(root, power_of_two(-bits));
  }
  // A root 2^-400 beside a critical point
  const Polynomial f = t * t * t - t * t * power_of_two(-400) + Polynomial(power_of_two(-1300));
  for (const RealAlgebraic& root : real_roots(f, -1, 1)) check_refinement(root, power_of_two(-1500));
}

TEST_CASE("real algebraic: to_double") {
  CHECK(std::fabs(RealAlgebraic::root_of(t * t - Polynomial(2), {1, 2}).to_double() - std::sqrt(2.0)) <=
        0x1p-52);
  CHECK(RealAlgebraic::root_of(t * (t * t - Polynomial(2)), {Rational(-1, 3), 1}).to_double() == 0);
  const Polynomial tiny = t * t * power_of_two(601) - Polynomial(1);  // root 2^-300.5
  CHECK(RealAlgebraic::root_of(tiny, {0, 1}).to_double() ==
        Approx(std::ldexp(std::sqrt(0.5), -300)).epsilon(1e-15));
  CHECK(RealAlgebraic::root_of(tiny, {-1, 0}).to_double() ==
        Approx(-std::ldexp(std::sqrt(0.5), -300)).epsilon(1e-15));
  CHECK(RealAlgebraic::root_of(tiny, {Rational(-1, power_of_two(302)), 1}).to_double() > 0);
}

TEST_CASE("real algebraic: order laws over all kinds of numbers") {
  const std::vector<RealAlgebraic> all = specimens();
  CHECK(all.size() == 26);
  std::vector<std::vector<int>> order(all.size(), std::vector<int>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    check_invariant(all[i]);
    for (std::size_t j = 0; j < all.size(); ++j) order[i][j] = sign_of(all[i] <=> all[j]);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(order[i][i] == 0);
    for (std::size_t j = 0; j < all.size(); ++j) {
      CHECK(order[i][j] == -order[j][i]);
      for (std::size_t k = 0; k < all.size(); ++k)
        if (order[i][j] <= 0 && order[j][k] <= 0) CHECK(order[i][k] == std::min(order[i][j], order[j][k]));
    }
  }
  // consistent with refinement, with signs and with comparison to rationals
  for (std::size_t i = 0; i < all.size(); ++i) {
    const RealAlgebraic fine = all[i].refined_to(power_of_two(-150));
    CHECK(sign_at(all[i].polynomial(), all[i]) == 0);
    for (std::size_t j = 0; j < all.size(); ++j) {
      CHECK(sign_of(fine <=> all[j]) == order[i][j]);
      if (all[j].is_rational()) {
        CHECK(all[i].compare(all[j].rational()) == order[i][j]);
        CHECK(sign_at(linear_factor(all[j].rational()), all[i]) == order[i][j]);
      }
    }
  }
}

TEST_CASE("real algebraic: the same number from different polynomials") {
  const Polynomial two = t * t - Polynomial(2);
  const RealAlgebraic x = RealAlgebraic::root_of(two, {1, 2});
  const RealAlgebraic y =
      RealAlgebraic::root_of(two * (t * t * t - Polynomial(7)), {Rational(5, 4), Rational(3, 2)});
  CHECK(x == y);
  CHECK(y == RealAlgebraic::root_of(-two, {1, Rational(3, 2)}));
  CHECK(x != RealAlgebraic::root_of(two, {-2, 1}));
  CHECK(x.compare(x.refined_to(power_of_two(-80)).interval().lower) == 1);
  CHECK(RealAlgebraic(Rational(1, 3)) ==
        RealAlgebraic::root_of(two * (t * Rational(3) - Polynomial(1)), {0, 1}));
}

TEST_CASE("real algebraic: conjugates extremely close") {
  const Polynomial two = t * t - Polynomial(2);
  const Polynomial f = two * two - Polynomial(Rational(1, pow(Integer(10), 40)));
  const std::vector<RealAlgebraic> roots = real_roots(f, -2, 2);
  REQUIRE(roots.size() == 4);
  CHECK(std::is_sorted(roots.begin(), roots.end()));
  const RealAlgebraic root_two = RealAlgebraic::root_of(two, {1, 2});
  CHECK(roots[2] < root_two);
  CHECK(root_two < roots[3]);
  CHECK(sign_at(two, roots[2]) == -1);
  CHECK(sign_at(two, roots[3]) == 1);
  CHECK(sign_at(f, root_two) == -1);
  CHECK(sign_at(f * two, root_two) == 0);
}

TEST_CASE("real algebraic: sign of a polynomial") {
  const Polynomial two = t * t - Polynomial(2);
  const Polynomial three = t * t - Polynomial(3);
  const RealAlgebraic x = RealAlgebraic::root_of(two * three, {1, Rational(3, 2)});
  CHECK(sign_at(two, x) == 0);
  CHECK(sign_at(two * two * linear_factor(4), x) == 0);
  CHECK(sign_at(three, x) == -1);  // shares the other root of x's polynomial
  CHECK(sign_at(three * linear_factor(2), x) == 1);
  CHECK(sign_at(three * (two + Polynomial(power_of_two(-200))), x) == -1);  // and is tiny here
  CHECK(sign_at(Polynomial(), x) == 0);
  CHECK(sign_at(-3, x) == -1);
  CHECK(sign_at(two + Polynomial(power_of_two(-900)), x) == 1);
  CHECK(sign_at(two - Polynomial(power_of_two(-900)), x) == -1);
  CHECK(sign_at(t * Rational(1, 3) - Polynomial(Rational(-7, 2)), x) == 1);
}

TEST_CASE("real algebraic: roots in a closed interval") {
  const Polynomial f = with_roots({0, Rational(1, 3), Rational(1, 3), 1, 2}) * (t * t - Polynomial(2));
  const std::vector<RealAlgebraic> roots = real_roots(f, 0, 2);
  REQUIRE(roots.size() == 5);
  CHECK(roots[0] == 0);
  CHECK(roots[1] == RealAlgebraic(Rational(1, 3)));
  CHECK(roots[2] == 1);
  CHECK(roots[3] == RealAlgebraic::root_of(t * t - Polynomial(2), {1, 2}));
  CHECK(roots[4] == 2);
  for (const RealAlgebraic& root : roots) check_invariant(root);
  CHECK(real_roots(f, Rational(1, 3), Rational(1, 3)).size() == 1);
  CHECK(real_roots(f, 3, 9).empty());
  CHECK(real_roots(-5, 0, 1).empty());
  CHECK(real_roots(t * t + Polynomial(1), -100, 100).empty());
}

TEST_CASE("real algebraic: all roots of the Chebyshev polynomial T_64") {
  Polynomial previous = 1, chebyshev = t;
  for (int n = 1; n < 64; ++n) {
    Polynomial next = t * Rational(2) * chebyshev - previous;
    previous = chebyshev;
    chebyshev = next;
  }
  const std::vector<RealAlgebraic> roots = real_roots(chebyshev, -1, 1);
  REQUIRE(roots.size() == 64);
  for (std::size_t k = 0; k < 64; ++k) {
    CHECK(std::fabs(roots[k].to_double() + std::cos((2 * static_cast<double>(k) + 1) * M_PI / 128)) < 1e-15);
    CHECK(sign_at(previous, roots[k]) == (k % 2 == 0 ? -1 : 1));  // T_63 alternates
  }
  check_refinement(roots[10], power_of_two(-500));
}

TEST_CASE("real algebraic: random quadratic numbers against exact squaring") {
  const std::uint64_t seed = 20250703;
  INFO("seed " << seed);
  Random random(seed);
  std::vector<QuadraticNumber> numbers;
  std::vector<RealAlgebraic> algebraic;
  while (numbers.size() < 24) {
    const QuadraticNumber x{random.rational(2, 3), random.rational(2, 2), random.integer(2, 3)};
    if (x.b == 0) continue;
    numbers.push_back(x);
    const Polynomial multiple = random.integer(0, 1) == 0 ? Polynomial(-1) : t * t * t - Polynomial(11);
    algebraic.push_back(x.number(multiple, 20));
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Polynomial f = random.polynomial(5, 4, 3);
    const QuadraticNumber value = value_at(f, numbers[i]);
    CHECK(sign_at(f, algebraic[i]) == sign_of_sum(value.a, value.b, value.c, 0, 0));
    CHECK(sign_at(f * numbers[i].polynomial(), algebraic[i]) == 0);
    for (std::size_t j = 0; j < numbers.size(); ++j)
      CHECK(sign_of(algebraic[i] <=> algebraic[j]) == compare(numbers[i], numbers[j]));
  }
}

TEST_CASE("real algebraic: random polynomials of high degree, order and refinement") {
  const std::uint64_t seed = 20250704;
  INFO("seed " << seed);
  Random random(seed);
  for (const int degree : {3, 8, 16, 40}) {
    const Polynomial common = random.big_polynomial(degree, 100);
    const std::vector<RealAlgebraic> roots = real_roots(common, -4, 4);
    const std::vector<RealAlgebraic> more = real_roots(common * random.big_polynomial(4, 30), -4, 4);
    CHECK(std::is_sorted(more.begin(), more.end()));
    // every root of the factor is one of the product
    for (const RealAlgebraic& root : roots) {
      check_refinement(root, power_of_two(-random.integer(1, 400)));
      CHECK(std::count(more.begin(), more.end(), root) == 1);
    }
  }
}

}  // namespace exsect::real_algebraic_test
