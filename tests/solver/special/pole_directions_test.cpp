// The directions of a pole, by the identity that defines them.
#include "special/pole_directions.h"

#include "support/catch.h"

namespace exsect::pole_directions_test {

TEST_CASE("pole_directions: the point and the direction make the patch") {
  const Point p = {3, -1, Rational(1, 2)};
  const RationalPatch x({{p, p, p}, {{1, 0, 0}, {1, 1, 2}, {0, 1, 0}}, {{2, 0, 1}, {2, 5, 1}, {0, 2, 1}}},
                        {{1, 2, 1}, {1, 1, 3}, {2, 1, 1}});
  const PolynomialVector d = pole_directions(x, p);
  for (const Rational& a : {Rational(0), Rational(1, 3), Rational(1)})
    for (const Rational& t : {Rational(0), Rational(2, 7), Rational(1)}) {
      const Rational w = x.component(3)(a, t);
      CHECK((1 / w) * (a * value(d, a, t)) + p == x(a, t));
    }
  Point sum = {0, 0, 0};
  for (const Point& q : directions_in_pole(d)) sum = sum + q;
  CHECK(sum == value(d, 0, 1));
}

TEST_CASE("common_normal: of vectors in one plane") {
  const Point e = {1, 0, 0}, f = {0, 1, 0}, zero = {0, 0, 0};
  CHECK(common_normal({e, zero, 2 * e + f}) == Point{0, 0, 1});
  CHECK(is_zero(common_normal({e, f, {0, 0, 1}})));
  CHECK(is_zero(common_normal({e, 3 * e})));
}

TEST_CASE("divided_by_first: times the first parameter it is what it was") {
  const BivariatePolynomial f = BivariatePolynomial::r() * BivariatePolynomial::s();
  CHECK(divided_by_first(f)(5, 7) == 7);
  CHECK(divided_by_first(BivariatePolynomial()).is_zero());
}

}  // namespace exsect::pole_directions_test
