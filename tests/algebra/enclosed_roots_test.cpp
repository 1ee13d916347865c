#include <exsect/algebra/descartes.h>
#include <exsect/algebra/enclosed_roots.h>
#include <exsect/algebra/polynomial.h>

#include <random>

#include "support/catch.h"

namespace exsect::enclosed_roots_test {

namespace {

Polynomial polynomial(const std::vector<Integer>& coefficients) {
  return Polynomial(std::vector<Rational>(coefficients.begin(), coefficients.end()));
}

/// prod (d_i t - n_i).
std::vector<Integer> with_roots(const std::vector<Rational>& roots) {
  std::vector<Integer> f = {1};
  for (const Rational& root : roots) {
    f.push_back(0);
    for (std::size_t i = f.size(); i-- > 0;)
      f[i] = (i > 0 ? f[i - 1] * denominator(root) : Integer(0)) - f[i] * numerator(root);
  }
  return f;
}

/// If the enclosure is decided, polynomials at its ends and in it have one simple root in each interval and
/// no others.
bool check(const EnclosedPolynomial& f, std::mt19937_64& random) {
  const auto found = isolate_enclosed_roots(f);
  if (!found) return false;
  for (int k = 0; k < 6; ++k) {
    std::vector<Integer> g = f.coefficients;
    for (Integer& c : g) c += f.error * (k < 2 ? 2 * k - 1 : static_cast<int>(random() % 3) - 1);
    const Polynomial p = polynomial(g);
    const auto expected = p.is_zero() ? std::vector<IsolatingInterval>() : isolate_roots(p, 0, 1);
    REQUIRE(found->size() == expected.size());
    for (const RationalInterval& interval : *found)
      CHECK(p.sign_at(interval.lower) * p.sign_at(interval.upper) == -1);
  }
  return true;
}

}  // namespace

TEST_CASE("enclosed roots: known ones", "[enclosed_roots]") {
  std::mt19937_64 random(1);
  const std::vector<Rational> roots = {{1, 3}, {2, 5}, {5, 7}, {9, 11}, {4, 3}, {-1, 2}};
  std::vector<Integer> f = with_roots(roots);
  for (Integer& c : f) c <<= 40;
  const auto exact = isolate_enclosed_roots({f, 0});
  REQUIRE(exact);
  REQUIRE(exact->size() == 4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(((*exact)[i].lower < roots[i] && roots[i] < (*exact)[i].upper));
  CHECK(check({f, 1}, random));
  CHECK(check({f, Integer(1) << 30}, random));
  CHECK_FALSE(check({f, Integer(1) << 60}, random));
}

TEST_CASE("enclosed roots: an error larger than everything decides nothing", "[enclosed_roots]") {
  for (const unsigned shift : {0U, 20U, 70U, 130U, 400U}) {
    const Integer scale = Integer(1) << shift;
    for (const unsigned more : {9U, 30U, 60U, 64U, 100U, 130U, 300U}) {
      CHECK_FALSE(isolate_enclosed_roots({{-341 * scale, 1024 * scale}, Integer(1) << (shift + more)}));
      CHECK_FALSE(isolate_enclosed_roots({{341 * scale, 3 * scale, scale}, Integer(1) << (shift + more)}));
    }
  }
}

TEST_CASE("enclosed roots: at the ends, multiple, none", "[enclosed_roots]") {
  CHECK_FALSE(isolate_enclosed_roots({with_roots({0, {1, 3}}), 0}));
  CHECK_FALSE(isolate_enclosed_roots({with_roots({1, {1, 3}}), 0}));
  CHECK_FALSE(isolate_enclosed_roots({with_roots({{1, 3}, {1, 3}}), 0}));
  CHECK_FALSE(isolate_enclosed_roots({with_roots({{1, 2}, {1, 3}, {2, 3}}), 0}));  // between two halves
  CHECK_FALSE(isolate_enclosed_roots({{0, 0, 0}, 0}));
  CHECK_FALSE(isolate_enclosed_roots({{0, 0, 0}, 5}));
  CHECK(isolate_enclosed_roots({{7}, 1}).value().empty());
  CHECK(isolate_enclosed_roots({{7, 0, 0, 0}, 1}).value().empty());  // a leading coefficient that may vanish
  CHECK(isolate_enclosed_roots({{-300, 1000, 0, 0}, 10}).value().size() == 1);
}

TEST_CASE("enclosed roots: random polynomials and errors", "[enclosed_roots]") {
  const unsigned seed = 5;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  int decided = 0;
  int with_roots_found = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const std::size_t degree = 1 + random() % 24;
    std::vector<Integer> f = {1};
    std::vector<Rational> roots;
    for (std::size_t i = 0; i < degree; ++i)
      roots.emplace_back(static_cast<int>(random() % 2001) - 500, 1009);  // some in (0,1), some not
    f = with_roots(roots);
    for (Integer& c : f) c += (static_cast<int>(random() % 3) - 1) * (Integer(1) << (5 * degree));
    INFO("trial " << trial);
    const EnclosedPolynomial enclosed{f, Integer(1) << (random() % (10 * degree))};
    if (check(enclosed, random)) {
      ++decided;
      with_roots_found += isolate_enclosed_roots(enclosed)->empty() ? 0 : 1;
    }
  }
  CHECK(decided >= 100);
  CHECK(with_roots_found >= 60);
}

}  // namespace exsect::enclosed_roots_test
