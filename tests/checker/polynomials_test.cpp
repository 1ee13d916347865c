#include <exsect/checker/polynomials.h>
#include <exsect/geometry/number.h>

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::polynomials_test {
namespace {

using checker::Polynomial;
using checker::Power;
using checker::product;
using checker::separates;
using random_pairs::Generator;
using Place = checker::Vector4<Rational>;

/// With terms in the parameters `first` and `second` alone.
Polynomial random_in(std::size_t first, std::size_t second, Generator& generator) {
  Polynomial result;
  for (int n = 0; n < 5; ++n) {
    Power power = {};
    power[first] = static_cast<int>(random_pairs::integer(generator, 0, 2));
    power[second] = static_cast<int>(random_pairs::integer(generator, 0, 2));
    result[power] = random_pairs::integer(generator, -4, 4);
  }
  return result;
}

Rational value(const Polynomial& a, const Place& w) {
  Rational sum = 0;
  for (const auto& [power, c] : a) {
    Rational term = c;
    for (std::size_t j = 0; j < 4; ++j)
      for (int n = 0; n < power[j]; ++n) term *= w[j];
    sum += term;
  }
  return sum;
}

/// a(p,q) a(p',q') = a(p,q') a(p',q) for p, p' the values of w_i and w_j and q, q' those of the others, on a
/// grid with more places in each parameter than exponents.
bool separates_on_grid(const Polynomial& a, std::size_t i, std::size_t j) {
  const Place origin = {7, Rational(5, 3), -9, Rational(11, 7)};
  for (int n = 0; n < 5 * 5 * 5 * 5; ++n) {
    const Place w = {n % 5, n / 5 % 5, n / 25 % 5, n / 125};
    Place inner = origin, outer = w;
    for (const std::size_t k : {i, j}) {
      inner[k] = w[k];
      outer[k] = origin[k];
    }
    if (value(a, w) * value(a, origin) != value(a, inner) * value(a, outer)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("products of polynomials in different parameters are told from others") {
  Generator generator(61);
  INFO("seed 61");
  CHECK(separates({}, 0, 2));
  CHECK(separates({{{0, 0, 0, 0}, 0}}, 0, 2));
  CHECK(separates({{{1, 2, 3, 0}, 5}}, 0, 2));
  CHECK_FALSE(separates({{{1, 0, 0, 0}, 1}, {{0, 1, 0, 0}, -1}}, 0, 2));
  for (int n = 0; n < 60; ++n) {
    const std::size_t i = n % 4, j = (n + 1 + n / 4 % 3) % 4;
    const auto rest = [&](std::size_t k) { return k != i && k != j; };
    std::size_t k = 0;
    while (!rest(k)) ++k;
    std::size_t l = k + 1;
    while (!rest(l)) ++l;
    Polynomial a = product(random_in(i, j, generator), random_in(k, l, generator));
    if (value(a, {7, Rational(5, 3), -9, Rational(11, 7)}) == 0) continue;
    INFO(n);
    CHECK(separates(a, i, j));
    CHECK(separates_on_grid(a, i, j));
    Power power = {};
    for (int& p : power) p = static_cast<int>(random_pairs::integer(generator, 0, 3));
    a[power] += 1;
    CHECK(separates(a, i, j) == separates_on_grid(a, i, j));
  }
}

}  // namespace exsect::polynomials_test
