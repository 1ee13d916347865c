#include <exsect/algebra/chebyshev_roots.h>
#include <exsect/algebra/descartes.h>
#include <exsect/algebra/polynomial.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "support/catch.h"

namespace exsect::chebyshev_roots_test {

namespace {

/// sum c_j T_j(2u - 1) by T_(j+1) = 2 t T_j - T_(j-1).
Polynomial from_chebyshev(const std::vector<Rational>& c) {
  const Polynomial t({-1, 2});
  Polynomial before = t, now = 1, sum;  // T_-1 = T_1
  for (const Rational& coefficient : c) {
    sum = sum + now * coefficient;
    Polynomial next = 2 * t * now - before;
    before = std::move(now);
    now = std::move(next);
  }
  return sum;
}

/// The coefficients in T_j(2u - 1) of a polynomial with rational roots, by multiplying t - root: t T_j is the
/// mean of T_(j+1) and T_|j-1|.
std::vector<Rational> with_roots(const std::vector<Rational>& roots) {
  std::vector<Rational> c = {1};
  for (const Rational& root : roots) {
    std::vector<Rational> next(c.size() + 1);
    for (std::size_t j = 0; j < c.size(); ++j) {
      next[j] -= c[j] * (2 * root - 1);
      next[j + 1] += j == 0 ? c[j] : c[j] / 2;
      if (j > 0) next[j - 1] += c[j] / 2;
    }
    c = std::move(next);
  }
  return c;
}

std::vector<WideBall> balls(const std::vector<Rational>& c, double radius = 0) {
  std::vector<WideBall> result;
  for (const Rational& q : c) result.push_back(WideBall::enclosing(RationalInterval{q, q}).widened(radius));
  return result;
}

}  // namespace

TEST_CASE("Chebyshev roots: known ones", "[chebyshev_roots]") {
  const std::vector<Rational> inside = {{1, 3}, {2, 5}, {401, 1000}, {5, 7}, {9, 11}, {999, 1000}};
  std::vector<Rational> roots = inside;
  roots.insert(roots.end(), {{4, 3}, {-1, 2}, {1001, 1000}});
  const std::vector<Rational> c = with_roots(roots);
  const auto found = isolate_chebyshev_roots(balls(c));
  REQUIRE(found);
  REQUIRE(found->size() == inside.size());
  for (std::size_t i = 0; i < inside.size(); ++i) {
    CHECK((*found)[i].lower < inside[i]);
    CHECK(inside[i] < (*found)[i].upper);
  }
  CHECK(isolate_chebyshev_roots(balls(c, 1e-12)));
  CHECK_FALSE(isolate_chebyshev_roots(balls(c, 1e-3)));
  CHECK(isolate_chebyshev_roots({3.0})->empty());
  CHECK(isolate_chebyshev_roots({3.0, 1.0, -1.0})->empty());
  CHECK(isolate_chebyshev_roots({0.25, 1.0})->size() == 1);
}

TEST_CASE("Chebyshev roots: undecided", "[chebyshev_roots]") {
  CHECK_THROWS_AS(isolate_chebyshev_roots({}), std::invalid_argument);
  CHECK_THROWS_AS(isolate_chebyshev_roots(std::vector<WideBall>(254, 1.0)), std::invalid_argument);
  CHECK_FALSE(isolate_chebyshev_roots({0.0}));
  CHECK_FALSE(isolate_chebyshev_roots({0.0, 0.0, 0.0}));
  CHECK_FALSE(isolate_chebyshev_roots(balls(with_roots({{1, 3}, {1, 3}}))));
  CHECK_FALSE(isolate_chebyshev_roots(balls(with_roots({0, {1, 3}}))));
  CHECK_FALSE(isolate_chebyshev_roots(balls(with_roots({1, {1, 3}}))));
  CHECK_FALSE(isolate_chebyshev_roots(balls(with_roots({{1, 2}, {1, 3}, {2, 3}}))));  // between two halves
  CHECK_FALSE(isolate_chebyshev_roots({WideBall(1).widened(std::numeric_limits<double>::infinity()), 0.1}));
  CHECK_FALSE(isolate_chebyshev_roots({WideBall(1).widened(std::numeric_limits<double>::quiet_NaN()), 0.1}));
}

TEST_CASE("Chebyshev roots: small errors of values that may be large ones of slopes", "[chebyshev_roots]") {
  std::vector<WideBall> c(129, 0.0);
  c[0] = 0.99e-3;
  c[1] = 1e-3;
  CHECK(isolate_chebyshev_roots(c)->size() == 1);
  c[128] = WideBall(0.0).widened(2e-6);  // some of these are not monotone
  CHECK_FALSE(isolate_chebyshev_roots(c));
  c[128] = -4e-6;
  CHECK(isolate_chebyshev_roots(c)->size() > 1);
}

TEST_CASE("Chebyshev roots: those of T_n, between its extremes", "[chebyshev_roots]") {
  for (const std::size_t n : {160U, 252U}) {
    std::vector<WideBall> c(n + 1, 0.0);
    c[n] = 1.0;
    const auto found = isolate_chebyshev_roots(c);
    REQUIRE(found);
    REQUIRE(found->size() == n);
    for (std::size_t k = 0; k < n; ++k) {  // at u = (1 + t) / 2, -t = cos((2 k + 1) pi / 2n)
      const double angle = (2 * static_cast<double>(k) + 1) * std::acos(-1.0) / static_cast<double>(4 * n);
      const double sine = std::sin(angle);
      CHECK(to_double((*found)[k].lower) < sine * sine);
      CHECK(sine * sine < to_double((*found)[k].upper));
    }
  }
}

TEST_CASE("Chebyshev roots: those of the exact polynomial", "[chebyshev_roots]") {
  const auto seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::size_t decided = 0, intervals = 0;
  for (int i = 0; i < 60; ++i) {
    // Some roots close together, and factors without roots; magnitudes over many powers of two.
    std::vector<Rational> roots;
    const std::size_t n = 1 + random() % 12;
    for (std::size_t k = 0; k < n; ++k) roots.emplace_back(static_cast<long>(random() % 2000) - 300, 1400);
    std::sort(roots.begin(), roots.end());
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    if (random() % 2 == 0) roots.push_back(roots.front() + Rational(1, 1 << 20));
    for (int far = static_cast<int>(random() % 60); far > 0; --far) roots.emplace_back(far % 2 == 0 ? 3 : -2);
    const std::vector<Rational> c = with_roots(roots);
    const Polynomial f = from_chebyshev(c);
    for (const Rational& root : roots) CHECK(f(root) == 0);
    const auto found = isolate_chebyshev_roots(balls(c));
    if (!found) continue;
    ++decided;
    intervals += found->size();
    CHECK(found->size() == isolate_roots(squarefree_part(f), 0, 1).size());
    for (const RationalInterval& interval : *found) {
      CHECK(f.sign_at(interval.lower) * f.sign_at(interval.upper) == -1);
    }
    for (std::size_t k = 1; k < found->size(); ++k) CHECK((*found)[k - 1].upper <= (*found)[k].lower);
  }
  CHECK(decided >= 40);
  CHECK(intervals >= 100);
}

}  // namespace exsect::chebyshev_roots_test
