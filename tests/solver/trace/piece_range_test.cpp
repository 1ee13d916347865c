#include "trace/piece_range.h"

#include <exsect/algebra/ball.h>
#include <exsect/algebra/double_double_ball.h>

#include <concepts>
#include <random>

#include "support/catch.h"

namespace exsect::piece_range_test {

namespace {

template <class T>
concept Comparable = requires(T a) {
  a < a;
}
|| requires(T a) { a == a; };
template <class T>
concept Subtractable = requires(T a) {
  a - a;
};

// A direction cannot be taken from two rounded ends.
static_assert(!Comparable<PieceEnd> && !Subtractable<PieceEnd>);
static_assert(std::convertible_to<PieceEnd, double> && !std::convertible_to<double, PieceEnd>);

template <class Ball>
Ball enclosing(const Rational& q) {
  return Ball::enclosing(q);
}

TEST_CASE("piece range: ends that round to one double keep their order") {
  using Wide = ArbBall<256>;
  for (const long bits : {60L, 100L, 200L}) {
    CAPTURE(bits);
    const Wide near = Wide::enclosing(Rational(3, 64));
    const Wide far = Wide::enclosing(Rational(3, 64) + power_of_two(-bits));
    const auto forwards = PieceRange::between(near, far);
    const auto backwards = PieceRange::between(far, near);
    REQUIRE(forwards);
    REQUIRE(backwards);
    CHECK(forwards->length() == 0);
    CHECK(forwards->direction() == 1);
    CHECK(backwards->direction() == -1);
    CHECK(backwards->reversed().direction() == 1);
    CHECK(forwards->doubt() >= to_double(power_of_two(-bits)));
    CHECK(forwards->doubt() < 0x1p-50);
  }
  CHECK_FALSE(PieceRange::between(Wide(0.5), Wide(0.5)));
  CHECK_FALSE(
      PieceRange::between(Wide(0.5).widened(0x1p-90), Wide::enclosing(Rational(1, 2) + power_of_two(-90))));
}

TEST_CASE("piece range: doubles are in order if that is certain") {
  CHECK_FALSE(PieceRange::between(0.25, 0.25));
  CHECK(PieceRange::between(0.25, 0.25 + 0x1p-54)->direction() == 1);
  CHECK(PieceRange::between(0.25, -0.25)->direction() == -1);
  CHECK_FALSE(PieceRange::between(0.25, 0.25 + 0x1p-40, 0x1p-41));
  CHECK(PieceRange::between(0.25, 0.25 + 0x1p-40, 0x1p-42)->direction() == 1);
  CHECK_FALSE(PieceRange::between(0.25, std::nan("")));
  CHECK_FALSE(PieceRange::between(0.25, 0.5, std::nan("")));
}

TEST_CASE("piece range: along the trace") {
  const PieceRange back = *PieceRange::between(0.5, -0.25);
  CHECK(back.precedes(0.5, 0.25));
  CHECK_FALSE(back.precedes(0.25, 0.25));
  CHECK_FALSE(back.precedes(0.25, 0.5));
  CHECK(back.ahead_of(0.25, 0.125) == 0.125);
  CHECK(back.ahead_of(0.25, -0.125) == 0.375);
  CHECK(back.ahead_of(0.25, 3) == -0.25);
  CHECK(back.ahead_of(0.25, -3) == 0.5);
  CHECK(back.clamped(7) == 0.5);
  CHECK(back.least() == -0.25);
  CHECK(back.greatest() == 0.5);
  CHECK(back.at(0) == 0.5);
  CHECK(back.at(1) == -0.25);
}

/// Against exact numbers.
template <class Ball>
void check_random_ranges(std::mt19937_64& random) {
  int certain = 0;
  for (int i = 0; i < 2000; ++i) {
    const Rational from = Rational(static_cast<long>(random() % 2001) - 1000, 977);
    const Rational step = power_of_two(-static_cast<long>(random() % 120)) * (random() % 2 == 0 ? 1 : -1);
    const auto range = PieceRange::between(enclosing<Ball>(from), enclosing<Ball>(from + step));
    if (!range) continue;
    ++certain;
    REQUIRE(range->direction() == (step > 0 ? 1 : -1));
    REQUIRE(abs(Rational(from - from_double(range->from()))) <= from_double(range->doubt()));
    REQUIRE(abs(Rational(from + step - from_double(range->to()))) <= from_double(range->doubt()));
    REQUIRE_FALSE(range->precedes(range->to(), range->from()));
  }
  CHECK(certain > 500);
}

TEST_CASE("piece range: random ends, against exact numbers") {
  const unsigned seed = 20251;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  check_random_ranges<DoubleBall>(random);
  check_random_ranges<DoubleDoubleBall>(random);
  check_random_ranges<ArbBall<256>>(random);
}

}  // namespace

}  // namespace exsect::piece_range_test
