// Quadratic polynomials with a parameter that are squares of lines.
#include "lift/line_square.h"

#include <random>

#include "support/catch.h"

namespace exsect::line_square_test {
namespace {

BivariatePolynomial number(const Rational& q) { return BivariatePolynomial::constant(q); }

BivariatePolynomial line(const Rational& a, const Rational& b, const Rational& c) {
  return number(a) * BivariatePolynomial::r() + number(b) * BivariatePolynomial::s() + number(c);
}

/// Every square that is found is one of f + t g, by multiplying out.
void check_squares(const BivariatePolynomial& f, const BivariatePolynomial& g,
                   const std::vector<LineSquare>& squares) {
  for (const LineSquare& square : squares) {
    CHECK(square.factor != 0);
    CHECK(square.line * square.line == number(square.factor) * (f + number(square.at) * g));
  }
}

}  // namespace

TEST_CASE("line squares: the parameters for which a pencil of conics has a double line") {
  const std::uint64_t seed = 20261127;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  const auto small = [&] { return Rational(static_cast<long>(random() % 19) - 9, 1 + random() % 3); };
  for (int i = 0; i < 50; ++i) {
    const Rational t = small(), k = small();
    const BivariatePolynomial l = line(small(), small(), small());
    if (k == 0 || l.total_degree() < 1) continue;
    // f + t g = k l^2 for a conic g without a double line.
    const BivariatePolynomial g = line(1, small(), small()) * line(small(), 1, small()) + number(1);
    const BivariatePolynomial f = number(k) * l * l - number(t) * g;
    const auto squares = line_squares(symmetric_matrix(f, g));
    check_squares(f, g, squares);
    CHECK(std::ranges::count(squares, t, &LineSquare::at) == 1);
  }
}

TEST_CASE("line squares: lines of one parameter, signs, and none") {
  const BivariatePolynomial r = BivariatePolynomial::r(), s = BivariatePolynomial::s();
  // s^2 - 1 + t: at t = 1; the first diagonal entry of the matrix is zero there.
  const BivariatePolynomial f = s * s - number(1);
  const auto squares = line_squares(symmetric_matrix(f, number(1)));
  REQUIRE(squares.size() == 1);
  CHECK(squares[0].at == 1);
  CHECK(squares[0].factor > 0);
  check_squares(f, number(1), squares);
  // -r^2 + t: the factor is negative.
  const auto negative = line_squares(symmetric_matrix(number(-1) * r * r, number(1)));
  REQUIRE(negative.size() == 1);
  CHECK(negative[0].factor < 0);
  check_squares(number(-1) * r * r, number(1), negative);
  // r^2 + s^2 + t is none; 2 - t^2 = 0 is not rational: r^2 + t r s + s^2 / 2.
  CHECK(line_squares(symmetric_matrix(r * r + s * s, number(1))).empty());
  CHECK(line_squares(symmetric_matrix(r * r + number(Rational(1, 2)) * s * s, r * s)).empty());
  // A square for all parameters.
  CHECK(line_squares(symmetric_matrix(r * r, r * r)).empty());
}

}  // namespace exsect::line_square_test
