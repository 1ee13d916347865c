// Arithmetic in real number fields: against identities of radicals, signs of polynomials at real algebraic
// numbers, and doubles.
#include <exsect/algebra/real_field.h>

#include <cmath>
#include <stdexcept>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::real_field_test {
namespace {

const Polynomial kTwo({-2, 0, 1});                      // root: sqrt 2
const Polynomial kTwoAndThree({1, 0, -10, 0, 1});       // root: sqrt 2 + sqrt 3
const Polynomial kOctic({1, 0, 0, 0, -4, 0, 0, 0, 1});  // t^8 - 4 t^4 + 1

RealAlgebraic greatest_root(const Polynomial& f) { return real_roots(f, 0, 100).back(); }

}  // namespace

TEST_CASE("real field: the square root of two") {
  const RealField field(greatest_root(kTwo));
  CHECK(field.degree() == 2);
  const FieldNumber a(field, Polynomial::variable());
  CHECK(a * a == FieldNumber(2));
  CHECK((a * a).rational() == 2);
  CHECK((a - a).is_zero());
  CHECK(FieldNumber(1) / a == a / 2);
  CHECK((a - 1) * (a + 1) == FieldNumber(1));
  CHECK(FieldNumber(1) / (a - 1) == a + 1);
  CHECK(sign(a - Rational(141421356, 100000000)) == 1);
  CHECK(sign(Rational(141421357, 100000000) - a) == 1);
  CHECK(sign(-a) == -1);
  CHECK(sign(FieldNumber()) == 0);
  CHECK(to_double(a) == std::sqrt(2.0));
  CHECK(to_double(-a) == -std::sqrt(2.0));
  CHECK(to_double(FieldNumber(Rational(1, 3))) == 1.0 / 3);
  CHECK_FALSE(a.is_rational());
  CHECK_THROWS_AS(a.rational(), std::domain_error);
  CHECK_THROWS_AS(a / (a * a - 2), std::domain_error);
  CHECK(-a == FieldNumber(field, Polynomial({0, -1})));
  const FieldNumber smaller(RealField(real_roots(kTwo, -2, 0).front()), Polynomial::variable());
  CHECK(sign(smaller) == -1);
  CHECK_THROWS_AS(a + smaller, std::invalid_argument);
  CHECK_THROWS_AS(a * smaller, std::invalid_argument);
  CHECK(a * (smaller - smaller + 3) == 3 * a);
}

TEST_CASE("real field: the generator's polynomial need not be irreducible") {
  for (const Rational& root : {Rational(0), Rational(3), Rational(1, 7)}) {
    const RealField field(real_roots(kTwo * Polynomial({-root, 1}), Rational(7, 5), Rational(3, 2)).front());
    CHECK(field.modulus() == kTwo);
  }
  const RealField rational{RealAlgebraic(Rational(2, 3))};
  CHECK(rational.degree() == 1);
  CHECK(FieldNumber(rational, Polynomial({1, 3, 9})).rational() == 7);
  CHECK(to_double(FieldNumber(rational, Polynomial::variable())) == 2.0 / 3);
}

TEST_CASE("real field: a sum of two square roots") {
  const RealField field(greatest_root(kTwoAndThree));
  CHECK(field.degree() == 4);
  const FieldNumber a(field, Polynomial::variable());
  const FieldNumber two = (a * a * a - 9 * a) / 2;
  const FieldNumber three = a - two;
  CHECK(two * two == FieldNumber(2));
  CHECK(three * three == FieldNumber(3));
  CHECK(to_double(two) == std::sqrt(2.0));
  CHECK(to_double(three) == std::sqrt(3.0));
  CHECK(sign(two - three) == -1);
  // A difference of 1e-30 or so: a convergent of sqrt 2.
  Rational p = 1, q = 1;
  for (int i = 0; i < 40; ++i) {
    const Rational next = p + 2 * q;
    q += p;
    p = next;
    CHECK(sign(two * q - p) == (i % 2 == 0 ? -1 : 1));
    CHECK(std::fabs(to_double(two * q - p) * 2 * std::sqrt(2.0) * to_double(q)) == Approx(1).epsilon(0.1));
  }
}

TEST_CASE("real field: random elements, by signs of polynomials and to all bits") {
  test::Random random(7);
  for (const Polynomial& f : {kTwo, kTwoAndThree, kOctic, Polynomial({-2, 0, 0, 1})}) {
    const RealAlgebraic root = greatest_root(f);
    const RealField field(root);
    for (int i = 0; i < 20; ++i) {
      INFO("field of degree " << f.degree() << ", element " << i);
      const Polynomial p = random.polynomial(f.degree() + 2, 50, 9);
      const Polynomial q = random.polynomial(f.degree() - 1, 50, 9);
      const FieldNumber a(field, p), b(field, q);
      CHECK(sign(a) == sign_at(p, root));
      CHECK(sign(a * b - a) == sign_at(p * q - p, root));
      if (!b.is_zero()) CHECK(a / b * b == a);
      if (!b.is_zero()) CHECK(sign(a / b - 1) == sign_at((p - q) * q, root));
      if (a.is_zero()) continue;
      const FieldNumber error = a - from_double(to_double(a));
      const FieldNumber size = sign(a) > 0 ? a : -a;
      CHECK(sign(size * power_of_two(-53) * Rational(257, 256) - error) >= 0);
      CHECK(sign(size * power_of_two(-53) * Rational(257, 256) + error) >= 0);
      const RationalInterval in = enclosure(a, 300);
      CHECK(sign(a - in.lower) >= 0);
      CHECK(sign(in.upper - a) >= 0);
      CHECK(sign(size * power_of_two(-300) - in.width()) >= 0);
    }
  }
}

}  // namespace exsect::real_field_test
