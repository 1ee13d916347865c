#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/descartes.h>
#include <exsect/algebra/sturm.h>

#include <functional>
#include <stdexcept>

#include "algebra/random_numbers.h"
#include "algebra/root_checks.h"
#include "support/catch.h"

namespace exsect::sturm_test {
using test::linear_factor;
using test::with_roots;

namespace {

/// Number of the given distinct roots in (a,b].
int count_known(const std::vector<Rational>& roots, const Rational& a, const Rational& b) {
  int count = 0;
  for (const Rational& root : roots)
    if (a < root && root <= b) ++count;
  return count;
}

Polynomial chebyshev(int n) {
  Polynomial previous = 1;
  Polynomial current = Polynomial::variable();
  for (int k = 1; k < n; ++k) {
    Polynomial next = Polynomial({0, 2}) * current - previous;
    previous = current;
    current = next;
  }
  return current;
}

/// t^n - 2 (at - 1)^2: two roots very close to 1/a.
Polynomial mignotte(int n, int a) {
  Polynomial power = 1;
  for (int k = 0; k < n; ++k) power *= Polynomial::variable();
  return power - Polynomial(2) * Polynomial({-1, a}) * Polynomial({-1, a});
}

/// Sturm's and Descartes' answers for the closed interval, and for each isolating interval alone.
void check_agreement(const Polynomial& f, const Rational& a, const Rational& b) {
  const SturmSequence sturm(f);
  const std::vector<IsolatingInterval> intervals = isolate_roots(f, a, b);
  test::check_isolating(f, a, b, intervals);
  CHECK(static_cast<int>(intervals.size()) == sturm.count_closed(a, b));
  for (const auto& [lower, upper] : intervals) CHECK(sturm.count_closed(lower, upper) == 1);
}

}  // namespace

TEST_CASE("sturm: constants and errors") {
  CHECK_THROWS_AS(SturmSequence(Polynomial()), std::domain_error);
  const SturmSequence constant{Polynomial(-3)};
  CHECK(constant.count_all() == 0);
  CHECK(constant.count_closed(0, 1) == 0);
  CHECK_THROWS_AS(constant.count(1, 0), std::invalid_argument);
}

TEST_CASE("sturm: intervals are open below and closed above") {
  const SturmSequence sturm(with_roots({0, 1, 2}));
  CHECK(sturm.count(0, 1) == 1);
  CHECK(sturm.count(0, 2) == 2);
  CHECK(sturm.count(-1, 0) == 1);
  CHECK(sturm.count(-1, 2) == 3);
  CHECK(sturm.count(2, 5) == 0);
  CHECK(sturm.count(1, 1) == 0);
  CHECK(sturm.count_closed(1, 1) == 1);
  CHECK(sturm.count_closed(0, 2) == 3);
  CHECK(sturm.count_closed(Rational(1, 2), Rational(3, 4)) == 0);
  CHECK(sturm.count_all() == 3);
}

TEST_CASE("sturm: zeros inside the chain are skipped") {
  // At 0 the derivative of t^3 - 3t + 1 is not zero, that of t^4 - 1 and of t^2 - 1 is.
  for (const Polynomial& f : {Polynomial({-1, 0, 1}), Polynomial({-1, 0, 0, 0, 1})}) {
    const SturmSequence sturm(f);
    CHECK(sturm.chain()[1].sign_at(0) == 0);
    CHECK(sturm.count(-2, 0) == 1);
    CHECK(sturm.count(0, 2) == 1);
    CHECK(sturm.count(0, 1) == 1);
    CHECK(sturm.count(-1, 0) == 0);
    CHECK(sturm.count_closed(-1, 1) == 2);
  }
  // Every member of the chain of a Chebyshev polynomial but the constants vanishes somewhere; at 0 every
  // other one.
  const SturmSequence sturm(chebyshev(9));
  CHECK(sturm.count(-1, 0) == 5);
  CHECK(sturm.count(0, 1) == 4);
  // At the zeros of the second remainder.
  const Polynomial f({-1, -1, 3, 0, 2, 1});
  const SturmSequence general(f);
  for (const Polynomial& member : general.chain()) {
    if (member.degree() != 1) continue;
    const Rational zero = -member.coefficient(0) / member.coefficient(1);
    CHECK(general.count(-100, zero) + general.count(zero, 100) == general.count_all());
  }
}

TEST_CASE("sturm: multiple roots count once, at the ends too") {
  const std::vector<Rational> roots{Rational(-1, 2), 0, Rational(1, 3), 2};
  const Polynomial complex({1, 1, 1});
  const Polynomial f = linear_factor(roots[0]) * linear_factor(roots[0]) * linear_factor(roots[1]) *
                       linear_factor(roots[2]) * linear_factor(roots[2]) * linear_factor(roots[2]) *
                       linear_factor(roots[3]) * linear_factor(roots[3]) * complex * complex;
  const std::vector<Rational> ends{-3, Rational(-1, 2), Rational(-1, 4), 0, Rational(1, 3), 1, 2, 7};
  for (const Polynomial& g : {f, -f, f * Polynomial(Rational(2, 7))}) {
    const SturmSequence sturm(g);
    CHECK(sturm.count_all() == 4);
    CHECK(sturm.chain().front().degree() == 6);
    CHECK(sturm.chain().back().degree() == 0);
    for (std::size_t i = 0; i < ends.size(); ++i)
      for (std::size_t j = i; j < ends.size(); ++j) {
        INFO("(" << ends[i] << ", " << ends[j] << "]");
        CHECK(sturm.count(ends[i], ends[j]) == count_known(roots, ends[i], ends[j]));
        CHECK(sturm.count_closed(ends[i], ends[j]) ==
              static_cast<int>(test::inside(roots, ends[i], ends[j]).size()));
      }
  }
}

TEST_CASE("sturm: the chain has Sturm's properties") {
  const std::uint64_t seed = 20240351;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 20; ++i) {
    const Polynomial f = random.polynomial(random.integer(2, 9), 9, 4);
    if (f.degree() < 2 || !is_squarefree(f)) continue;
    const std::vector<Polynomial> chain = SturmSequence(f).chain();
    CHECK(chain[0] == f.primitive());
    CHECK(chain[1] == f.derivative().primitive());
    for (std::size_t k = 2; k < chain.size(); ++k) {
      // A positive multiple of p_{k-2} plus one of p_k is divisible by p_{k-1}.
      const Polynomial remainder = divide(chain[k - 2], chain[k - 1]).remainder;
      CHECK(chain[k] == (-remainder).primitive());
    }
  }
}

TEST_CASE("sturm and descartes agree: named families") {
  for (const int n : {2, 3, 5, 8, 16, 32}) {
    INFO("degree " << n);
    std::vector<Rational> wilkinson;
    for (int k = 1; k <= n; ++k) wilkinson.push_back(k);
    check_agreement(with_roots(wilkinson), 0, n + 1);
    check_agreement(with_roots(wilkinson), 1, n);
    check_agreement(chebyshev(n), -1, 1);
    check_agreement(chebyshev(n), 0, 1);
    check_agreement(chebyshev(n), -5, Rational(1, 3));
    if (n >= 3) {
      check_agreement(mignotte(n, 1000), 0, 1);
      check_agreement(mignotte(n, 1 << 20), -1, 1);
      check_agreement(mignotte(n, 3), Rational(-100), Rational(1, 3));
    }
  }
}

TEST_CASE("sturm and descartes agree: random polynomials") {
  const std::uint64_t seed = 20240352;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 120; ++i) {
    const int degree = i < 100 ? random.integer(1, 16) : random.integer(17, 32);
    Polynomial f = i % 2 == 0 ? random.polynomial(degree, 50, 1 + i % 5) : random.big_polynomial(degree, 150);
    if (i % 3 == 0) {
      // Random Bernstein coefficients: many real roots in the interval.
      f = from_bernstein(random.polynomial(degree, 50).coefficients());
    }
    if (f.is_zero() || !is_squarefree(f)) continue;
    INFO("case " << i);
    check_agreement(f, 0, 1);
    const Rational a = random.rational(5, 9);
    check_agreement(f, a, a + Rational(random.integer(1, 60), 10));
  }
}

TEST_CASE("sturm and descartes agree: products with known roots and clusters") {
  const std::uint64_t seed = 20240353;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 40; ++i) {
    std::vector<Rational> roots;
    const int clusters = random.integer(1, 4);
    for (int c = 0; c < clusters; ++c) {
      const Rational centre(random.integer(0, 16), 16);
      const long gap = random.integer(3, 80);
      for (int k = random.integer(0, 4); k >= 0; --k)
        roots.push_back(centre + random.integer(-9, 9) * power_of_two(-gap));
    }
    roots = test::sorted(roots);
    const Polynomial f = with_roots(roots) * Polynomial({random.integer(1, 9), 1, 1});
    INFO("case " << i);
    check_agreement(f, 0, 1);
    const SturmSequence sturm(f);
    CHECK(sturm.count_all() == static_cast<int>(roots.size()));
    CHECK(sturm.count(0, 1) == count_known(roots, 0, 1));
    CHECK(sturm.count_closed(roots.front(), roots.back()) == static_cast<int>(roots.size()));
  }
}

}  // namespace exsect::sturm_test
