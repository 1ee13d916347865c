// Numbers recognised in one field: against numbers made in a field, whose values are all that is told.
#include <exsect/algebra/common_field.h>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::common_field_test {
namespace {

constexpr int kBits = 2000;

RealAlgebraic root_above(const Polynomial& f, const Rational& lower) {
  return real_roots(f, lower, lower + 100).front();
}

std::vector<Rational> values(const std::vector<FieldNumber>& numbers) {
  std::vector<Rational> result;
  for (const FieldNumber& a : numbers) {
    const Rational scaled = enclosure(a, kBits + 20).midpoint() * power_of_two(kBits + 10);
    result.push_back(Rational(Integer(numerator(scaled) / denominator(scaled))) * power_of_two(-kBits - 10));
  }
  return result;
}

/// f(a) = 0, exactly.
bool is_root(const Polynomial& f, const FieldNumber& a) {
  FieldNumber value;
  for (int i = f.degree(); i >= 0; --i) value = value * a + f.coefficient(i);
  return value.is_zero();
}

}  // namespace

TEST_CASE("common field: rational numbers") {
  const auto found = recognised_in_field({Rational(1, 3), 0, 1, Rational(-123456789, 987654321)}, kBits, 8);
  REQUIRE(found);
  CHECK((*found)[0].rational() == Rational(1, 3));
  CHECK((*found)[1].is_zero());
  CHECK((*found)[2].rational() == 1);
  CHECK((*found)[3].rational() == Rational(-123456789, 987654321));
}

TEST_CASE("common field: square roots of different numbers") {
  const auto root = [](int n) {
    return FieldNumber(RealField(root_above(Polynomial({Rational(-n), 0, 1}), 0)), Polynomial::variable()) /
           4;
  };
  const auto found = recognised_in_field(values({root(2), root(3), Rational(1, 7), root(6)}), kBits, 8);
  REQUIRE(found);
  CHECK((*found)[0] * (*found)[0] == FieldNumber(Rational(1, 8)));
  CHECK((*found)[1] * (*found)[1] == FieldNumber(Rational(3, 16)));
  CHECK((*found)[2] == FieldNumber(Rational(1, 7)));
  CHECK((*found)[0] * (*found)[1] * 4 == (*found)[3]);
  const auto octic = recognised_in_field(values({root(2), root(3), root(5), FieldNumber(0)}), kBits, 8);
  REQUIRE(octic);
  CHECK((*octic)[2] * (*octic)[2] == FieldNumber(Rational(5, 16)));
  CHECK(sign((*octic)[2]) == 1);
  // Degree 16, or more than is asked for.
  CHECK_FALSE(recognised_in_field(values({root(2), root(3), root(5), root(7)}), kBits, 8));
  CHECK_FALSE(recognised_in_field(values({root(2), root(3)}), kBits, 2));
}

TEST_CASE("common field: numbers of a field of odd degree, and of nested roots") {
  test::Random random(5);
  for (const Polynomial& f : {Polynomial({-2, 0, 0, 1}), Polynomial({1, -5, 0, 0, 0, 1}),
                              Polynomial({-1, 0, 0, -3, 0, 0, 1}), Polynomial({2, 0, -4, 0, 1})}) {
    const RealField field(root_above(f, Rational(1, 100)));
    std::vector<FieldNumber> numbers;
    std::vector<Polynomial> annihilators;
    for (int i = 0; i < 4; ++i)
      numbers.push_back(FieldNumber(field, random.polynomial(field.degree() - 1, 5, 3)) / 64);
    const std::vector<Rational> told = values(numbers);
    const auto found = recognised_in_field(told, kBits, 8);
    REQUIRE(found);
    for (std::size_t i = 0; i < 4; ++i) {
      const RationalInterval in = enclosure((*found)[i], kBits);
      CHECK(abs(in.midpoint() - told[i]) < power_of_two(-kBits / 2));
    }
    // Relations between the numbers hold of what is found.
    const auto relation = [&](const std::vector<FieldNumber>& n) { return n[0] * n[1] - n[2] * n[3]; };
    const auto both = values({relation(numbers), relation(*found)});
    CHECK(abs(both[0] - both[1]) < power_of_two(-kBits / 2 + 8));
    const Polynomial of_generator = field.modulus();
    const auto generator =
        recognised_in_field(values({FieldNumber(field, Polynomial::variable()) / 8}), kBits, 8);
    REQUIRE(generator);
    CHECK(is_root(of_generator, (*generator)[0] * 8));
  }
}

TEST_CASE("common field: numbers that are in none") {
  // 0.1 + 0.01 + 0.0001 + 0.0000000000000001 + ..., with digits at powers of two: no algebraic number
  // (Mahler).
  Rational sparse = 0;
  for (int place = 1; place < kBits; place *= 2) sparse += power_of_two(-place);
  CHECK_FALSE(recognised_in_field({Rational(1, 2), sparse}, kBits / 2, 8));
  test::Random random(11);
  for (int i = 0; i < 4; ++i) {
    const Rational digits = Rational(random.big_integer(kBits)) * power_of_two(-kBits);
    CHECK_FALSE(recognised_in_field({digits, Rational(1, 2)}, kBits, 8));
  }
}

}  // namespace exsect::common_field_test
