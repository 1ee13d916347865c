// Doubles with bounds of their errors: never wrong, and narrow.
#include <exsect/checker/map.h>

#include <cmath>

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::enclosure_test {
namespace {

using checker::Enclosure;

/// A number that is a, known or not.
bool may_be(const Enclosure& a, const Rational& q) { return !(a < Enclosure(q)) && !(a > Enclosure(q)); }
/// a is known within this distance of q.
bool within(const Enclosure& a, const Rational& q, const Rational& distance) {
  return Enclosure(q - distance) < a && a < Enclosure(q + distance);
}

/// sum + sum a
Enclosure with_multiple(Enclosure sum, const Enclosure& a) {
  add_multiple(sum, Enclosure(sum), a);
  return sum;
}

Rational random_rational(random_pairs::Generator& generator) {
  const long n = random_pairs::integer(generator, -1000000, 1000000);
  const Rational q(n, random_pairs::integer(generator, 1, 1000000));
  return q * power_of_two(random_pairs::integer(generator, -40, 40));
}

}  // namespace

TEST_CASE("exact doubles compare exactly, other numbers only where it is certain") {
  CHECK(Enclosure(Rational(1, 4)) == Enclosure(0.25));
  CHECK(Enclosure(Rational(1, 4)) <= Enclosure(0.25));
  CHECK_FALSE(Enclosure(Rational(1, 4)) < Enclosure(0.25));
  const Enclosure third(Rational(1, 3));
  CHECK_FALSE(third == third);
  CHECK_FALSE(third <= third);
  CHECK(third < Enclosure(Rational(1, 3) + power_of_two(-50)));
  CHECK(Enclosure(0) < Enclosure(5e-324));
}

TEST_CASE("where doubles overflow, underflow or divide by zero nothing wrong is certain") {
  const Enclosure huge(1e300);
  for (const Enclosure& a :
       {huge * huge, huge / Enclosure(0), Enclosure(power_of_two(2000)), huge * huge - huge * huge}) {
    CHECK_FALSE(a < Enclosure(0));
    CHECK_FALSE(a > Enclosure(0));
    CHECK_FALSE(a == a);
  }
  const Enclosure tiny(1e-300);
  CHECK_FALSE(tiny * tiny <= Enclosure(0));
  CHECK_FALSE(tiny * tiny == Enclosure(0));
  CHECK(may_be(tiny * tiny, from_double(1e-300) * from_double(1e-300)));
  CHECK_FALSE(half(Enclosure(5e-324)) == Enclosure(5e-324) - Enclosure(5e-324));
  CHECK(may_be(half(Enclosure(5e-324)), from_double(5e-324) / 2));
}

TEST_CASE("what is not known makes every result unknown, in either order") {
  const Enclosure unknown = Enclosure(1) / Enclosure(0);
  const Enclosure nan(std::numeric_limits<double>::quiet_NaN());
  const Enclosure infinite(std::numeric_limits<double>::infinity());
  const Enclosure one(1);
  for (const Enclosure& a : {unknown, nan, infinite, Enclosure(1e200) * Enclosure(1e200)}) {
    for (const Enclosure& b :
         {larger(a, one), larger(one, a), a + one, one - a, with_multiple(one, a), with_multiple(a, one),
          a * Enclosure(0), one / a, a / one, magnitude(a), half(a), root_above(a), -a, a - a}) {
      for (const Enclosure& c : {one, Enclosure(-1), Enclosure(0), Enclosure(1e308), a}) {
        CHECK_FALSE(b < c);
        CHECK_FALSE(b > c);
        CHECK_FALSE(b <= c);
        CHECK_FALSE(b >= c);
        CHECK_FALSE(b == c);
      }
    }
    CHECK_FALSE(std::isfinite(checker::above(a)));
  }
}

TEST_CASE("a number of unknown sign has its whole magnitude") {
  // -1 ± 2^11: at least 2^10, whatever the sign is.
  const Enclosure a(Rational(-1), Rational(2048));
  for (const Enclosure& size : {magnitude(a), checker::magnitude(a), checker::Ball<Enclosure>(a).magnitude()})
    CHECK_FALSE(size < Enclosure(2047));
  CHECK_FALSE(checker::Ball<Enclosure>(a).magnitude() <= Enclosure(2046));
}

TEST_CASE("numbers near the greatest double compare only where it is certain") {
  const Enclosure wide(from_double(0x1p1023), from_double(0x1.8p1023));
  CHECK_FALSE(-wide <= wide);
  CHECK_FALSE(-wide < wide);
  CHECK(Enclosure(-0x1.8p1023) < Enclosure(0x1.8p1023));
}

TEST_CASE("enclosures hold the results of exact arithmetic") {
  random_pairs::Generator generator(30);
  INFO("seed 30");
  for (int i = 0; i < 3000; ++i) {
    Rational q = random_rational(generator);
    Enclosure a(q);
    Rational scale = abs(q);
    for (int k = 0; k < 6; ++k) {
      const Rational p = random_rational(generator);
      const Enclosure b(p);
      const long kind = random_pairs::integer(generator, 0, 4);
      if (kind == 0) a += b, q += p, scale += abs(p);
      if (kind == 1) a -= b, q -= p, scale += abs(p);
      if (kind == 2) a = a * b, q *= p, scale *= abs(p);
      if (kind == 4) add_multiple(a, b, a), q += p * q, scale += abs(p) * scale;
      if (kind == 3 && p != 0) a = a / b, q /= p, scale /= abs(p);
      INFO(i << ": " << k);
      REQUIRE(may_be(a, q));
      REQUIRE(within(a, q, (scale + power_of_two(-900)) * power_of_two(-48)));
      REQUIRE(may_be(half(a), q / 2));
      REQUIRE(may_be(magnitude(a), abs(q)));
      REQUIRE(may_be(larger(a, b), q < p ? p : q));
      const Enclosure root = root_above(magnitude(a));
      REQUIRE_FALSE(root * root < magnitude(a));
    }
  }
}

}  // namespace exsect::enclosure_test
