#include <exsect/algebra/bernstein_box.h>
#include <exsect/algebra/positive_on_square.h>
#include <exsect/algebra/sturm.h>

#include "random_numbers.h"
#include "support/catch.h"

namespace exsect::positive_on_square_test {
using exsect::test::Random;

namespace {

const BivariatePolynomial r = BivariatePolynomial::r();
const BivariatePolynomial s = BivariatePolynomial::s();

BivariatePolynomial c(const Rational& value) { return BivariatePolynomial::constant(value); }

BivariatePolynomial square(const BivariatePolynomial& f) { return f * f; }

bool holds(const RationalInterval& t, const Rational& value) { return t.lower <= value && value <= t.upper; }

/// The place is in the square, and f vanishes in its box as far as a box can show it.
void check_place(const BivariatePolynomial& f, const NotPositive& place) {
  for (const RationalInterval* t : {&place.r, &place.s}) {
    CHECK(t->width() <= power_of_two(-60));
    CHECK((t->upper >= 0 && t->lower <= 1));
  }
  const Rational value = f(place.r.midpoint(), place.s.midpoint());
  if (place.r.width() == 0 && place.s.width() == 0)
    CHECK(sign(value) == place.sign);
  else
    CHECK(abs(value) < power_of_two(-40));
}

/// +1, -1: the sign on the whole square; 0: not one sign, as far as 2^16 parts of the square show it.
int sign_by_parts(const BernsteinBox& part, int depth) {
  if (part.sign() != 0 || depth == 0) return part.sign();
  const auto [low, high] = depth % 2 == 0 ? part.split_r() : part.split_s();
  const int first = sign_by_parts(low, depth - 1);
  return first != 0 && first == sign_by_parts(high, depth - 1) ? first : 0;
}

}  // namespace

TEST_CASE("zeros in one point of the square are found", "[positive_on_square]") {
  const Rational half(1, 2), third(1, 3);
  // Inside at a rational point that no subdivision meets, and at one that it meets.
  for (const auto& [a, b] :
       {std::pair{third, Rational(2, 7)}, {half, Rational(3, 4)}, {Rational(1, 1000), third}}) {
    const BivariatePolynomial f = square(r - c(a)) + square(s - c(b));
    const auto place = not_positive_on_square(f);
    REQUIRE(place);
    CHECK(place->sign == 0);
    CHECK(holds(place->r, a));
    CHECK(holds(place->s, b));
    CHECK_FALSE(not_positive_on_square(f + c(power_of_two(-200))));
    const auto below = not_positive_on_square(f - c(power_of_two(-200)));
    REQUIRE(below);
    check_place(f - c(power_of_two(-200)), *below);
  }
  // At the irrational point (sqrt(1/2), sqrt(1/3)), and on a side.
  const BivariatePolynomial irrational = square(c(2) * r * r - c(1)) + square(c(3) * s * s - c(1));
  const auto place = not_positive_on_square(irrational);
  REQUIRE(place);
  CHECK(to_double(place->r.midpoint()) == Approx(std::sqrt(0.5)).epsilon(1e-15));
  CHECK(to_double(place->s.midpoint()) == Approx(std::sqrt(1.0 / 3)).epsilon(1e-15));
  const auto on_side = not_positive_on_square(square(s - c(third)) + (c(1) - r));
  REQUIRE(on_side);
  CHECK((on_side->r.lower == 1 && on_side->r.upper == 1 && holds(on_side->s, third)));
}

TEST_CASE("double curves of zeros are found, and those outside are not", "[positive_on_square]") {
  const Rational half(1, 2);
  const BivariatePolynomial circle = square(r - c(half)) + square(s - c(half)) - c(Rational(1, 9));
  for (const BivariatePolynomial& f :
       {square(circle), square(circle) * (r + c(1)), square(r - s + c(Rational(1, 3))),
        square(c(3) * r - c(1)), square(c(3) * s - c(1))}) {
    const auto place = not_positive_on_square(f);
    REQUIRE(place);
    check_place(f, *place);
    CHECK_FALSE(not_positive_on_square(f + c(power_of_two(-100))));
  }
  CHECK_FALSE(not_positive_on_square(square(r + s - c(3))));
  CHECK_FALSE(not_positive_on_square(square(r - c(Rational(-1, 1000)))));
}

TEST_CASE("the corner (0,0) is named where the polynomial is not positive there", "[positive_on_square]") {
  for (const auto& [f, sign] : {std::pair{c(0), 0}, {c(-1), -1}, {r + s, 0}, {r - c(1), -1}}) {
    const auto place = not_positive_on_square(f);
    REQUIRE(place);
    CHECK((place->r.upper == 0 && place->s.upper == 0));
    CHECK(place->sign == sign);
  }
  CHECK_FALSE(not_positive_on_square(c(power_of_two(-3000))));
}

TEST_CASE("random polynomials agree with subdivision and with Sturm chains on lines",
          "[positive_on_square]") {
  const auto seed = 241u;
  INFO("seed " << seed);
  Random random(seed);
  int positive = 0, negative = 0;
  for (int round = 0; round < 400; ++round) {
    BivariatePolynomial f;
    for (int i = 0; i <= 3; ++i)
      for (int j = 0; j <= 3; ++j) {
        BivariatePolynomial term = c(random.rational(6, 4));
        for (int k = 0; k < i; ++k) term = term * r;
        for (int k = 0; k < j; ++k) term = term * s;
        f += term;
      }
    f += c(random.integer(0, 12));
    const auto place = not_positive_on_square(f);
    const int by_parts = sign_by_parts(BernsteinBox(f, {0, 1}, {0, 1}), 16);
    if (by_parts != 0) CHECK(place.has_value() == (by_parts < 0));
    for (int line = 0; line <= 8; ++line) {
      const Polynomial across = f.at_r(Rational(line, 8));
      if (across.is_zero()) continue;
      const bool has_zero = across(0) <= 0 || SturmSequence(across).count_closed(0, 1) > 0;
      if (has_zero) CHECK(place);
    }
    if (place) check_place(f, *place);
    (place ? negative : positive) += 1;
  }
  CHECK(positive > 50);
  CHECK(negative > 50);
}

}  // namespace exsect::positive_on_square_test
