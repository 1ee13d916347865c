// Squares around the zeros of polynomials.
#include "special/remaining_squares.h"

#include "support/catch.h"

namespace exsect::remaining_squares_test {
namespace {

/// r - c and s - d, and their opposites: none is positive at (c,d) alone.
std::vector<BivariatePolynomial> only_at(const Rational& c, const Rational& d) {
  const BivariatePolynomial f = BivariatePolynomial::r() + BivariatePolynomial::constant(-c);
  const BivariatePolynomial g = BivariatePolynomial::s() + BivariatePolynomial::constant(-d);
  return {f, f * Polynomial(-1), g, g * Polynomial(-1)};
}

bool is_small(const Rectangle& square) {
  return square.r.width() < Rational(1, 50) && square.s.width() < Rational(1, 50);
}

}  // namespace

TEST_CASE("remaining_squares: they hold the point, on dividing lines too, and are near it") {
  for (const Rational& c : {Rational(1, 3), Rational(1, 2), Rational(0), Rational(1)}) {
    const auto squares = remaining_squares(only_at(c, Rational(5, 7)), is_small);
    REQUIRE(squares);
    REQUIRE(!squares->empty());
    for (const Rectangle& square : *squares) {
      CHECK(square.r.lower <= c);
      CHECK(c <= square.r.upper);
      CHECK(square.s.lower <= Rational(5, 7));
      CHECK(Rational(5, 7) <= square.s.upper);
    }
  }
}

TEST_CASE("remaining_squares: none where the point is outside, the square for no condition, an end to work") {
  CHECK(remaining_squares(only_at(Rational(3, 2), Rational(1, 2)), is_small)->empty());
  const auto all = remaining_squares({BivariatePolynomial()}, [](const Rectangle&) { return true; });
  REQUIRE(all->size() == 1);
  CHECK(all->front().r.width() == 1);
  CHECK(!remaining_squares(only_at(Rational(1, 3), Rational(1, 2)), [](const Rectangle&) { return false; }));
}

TEST_CASE("remaining_squares: a corner that is never small ends the search at once") {
  // r^2 - 1/2 and s - 1/4: none is positive over a part of the square that is to be within a smaller one.
  const std::vector<BivariatePolynomial> tests = {
      BivariatePolynomial::r() * BivariatePolynomial::r() + BivariatePolynomial::constant(Rational(-1, 2)),
      BivariatePolynomial::s() + BivariatePolynomial::constant(Rational(-1, 4))};
  int calls = 0;
  const auto within = [&](const Rational& r, const Rational& s) {
    return remaining_squares(tests, [&, r, s](const Rectangle& square) {
      ++calls;
      return square.r.upper <= r && square.s.upper <= s;
    });
  };
  CHECK(within(Rational(3, 4), Rational(1, 3)));
  calls = 0;
  CHECK(!within(Rational(2, 3), Rational(1, 3)));
  CHECK(!within(Rational(3, 4), Rational(1, 5)));
  CHECK(calls < 100);
}

}  // namespace exsect::remaining_squares_test
