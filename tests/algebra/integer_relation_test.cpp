// Integer relations: those of algebraic numbers, and none between numbers without one.
#include <exsect/algebra/integer_relation.h>
#include <exsect/algebra/real_algebraic.h>

#include "support/catch.h"

namespace exsect::integer_relation_test {
namespace {

constexpr int kBits = 600;

/// The root in [0,1] to the precision of the search.
Rational near_root(const Polynomial& f) {
  return real_roots(f, 0, 1).at(0).refined_to(power_of_two(-kBits - 20)).interval().lower;
}
std::vector<Rational> powers(const Rational& a, int degree) {
  std::vector<Rational> result = {1};
  for (int i = 0; i < degree; ++i) result.push_back(result.back() * a);
  return result;
}

}  // namespace

TEST_CASE("the minimal polynomial of an algebraic number is an integer relation of its powers") {
  for (const Polynomial& f :
       {Polynomial({1, -8, 8}), Polynomial({-1, 0, 0, 5}), Polynomial({-3, 1, 7, 0, 11})}) {
    const auto relation = integer_relation(powers(near_root(f), f.degree()), kBits);
    REQUIRE(relation);
    std::vector<Rational> found(relation->begin(), relation->end());
    if (found.back() < 0)
      for (Rational& c : found) c = -c;
    CHECK(Polynomial(found) == f);
  }
}

TEST_CASE("a number of a field is an integer relation with the powers of its generator") {
  const Rational root = near_root(Polynomial({-1, 0, 0, 5}));
  std::vector<Rational> values = powers(root, 2);
  values.push_back(Rational(2, 7) - root / 3 + 5 * root * root);
  const auto relation = integer_relation(values, kBits);
  REQUIRE(relation);
  const Integer sign = (*relation)[3] < 0 ? 1 : -1;
  CHECK(*relation == std::vector<Integer>{6 * sign, -7 * sign, 105 * sign, -21 * sign});
}

TEST_CASE("numbers of different fields have no short relation") {
  const Rational a = near_root(Polynomial({-1, 0, 0, 5}));
  const Rational b = near_root(Polynomial({1, -8, 8}));
  CHECK_FALSE(integer_relation({1, a, b}, kBits));
  CHECK_FALSE(integer_relation(powers(a, 2), kBits));
}

}  // namespace exsect::integer_relation_test
