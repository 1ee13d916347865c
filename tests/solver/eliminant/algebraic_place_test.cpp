// The parameters of solutions as numbers of one field: those of singular points, against their equations.
#include <exsect/algebra/real_algebraic.h>
#include <exsect/solver/algebraic_place.h>
#include <exsect/solver/intersect.h>

#include <algorithm>

#include "support/catch.h"
#include "support/families.h"

namespace exsect::algebraic_place_test {
namespace {

using families::Plane;

ParameterBox box_of(const BezierPatch& x, const BezierPatch& y, NodeKind kind) {
  const IntersectResult result = intersect(x, y);
  for (const Node& node : result.graph.nodes)
    if (std::count(node.kinds.begin(), node.kinds.end(), kind) > 0) return node.box;
  throw std::logic_error("no such node");
}

/// The parameter that the place gives, exactly.
void check_root(const AlgebraicPlace& place, std::size_t i, const Polynomial& f,
                const RationalInterval& range) {
  INFO(i);
  const RealAlgebraic a = RealAlgebraic::root_of(place.modulus.primitive(), place.between);
  CHECK(sign_at(f.compose(place.at[i]), a) == 0);
  CHECK(sign_at(place.at[i] - range.lower, a) >= 0);
  CHECK(sign_at(place.at[i] - range.upper, a) <= 0);
}

}  // namespace

TEST_CASE("a touch point with parameters in a quadratic field") {
  const ExactCase c = families::cap(0, Plane::quadratic);
  const ParameterBox box = box_of(c.x, c.y, NodeKind::touch);
  const auto place = algebraic_place(c.x, c.y, box);
  REQUIRE(place);
  CHECK(place->modulus.degree() == 2);
  CHECK(place->modulus.leading_coefficient() == 1);
  for (const std::size_t i : {0U, 1U}) CHECK(place->at[i] == Polynomial(Rational(1, 2)));
  check_root(*place, 2, Polynomial({-1, 1, 1}), box[2]);  // r + r² = 1
  check_root(*place, 3, Polynomial({1, -3, 1}), box[3]);  // 3 s - s² = 1
}

TEST_CASE("a place between others, none of which is a solution") {
  const ExactCase c = families::cap(0, Plane::quadratic);
  ParameterBox box = box_of(c.x, c.y, NodeKind::touch);
  std::swap(box[2], box[3]);
  CHECK_FALSE(algebraic_place(c.x, c.y, box));
  box.fill({Rational(1, 3), Rational(1, 3)});
  CHECK_FALSE(algebraic_place(c.x, c.y, box));
}

TEST_CASE("a place with rational parameters") {
  const ExactCase c = families::cap(0, Plane::square);
  const auto place = algebraic_place(c.x, c.y, box_of(c.x, c.y, NodeKind::touch));
  REQUIRE(place);
  CHECK(place->modulus.degree() == 1);
  for (const Polynomial& parameter : place->at) CHECK(parameter == Polynomial(Rational(1, 2)));
}

TEST_CASE("a place of which each parameter is in another field") {
  // (u², v², 0) and (2/5 + r/5, s/3, 0) at r = s = 1: u = √(3/5), v = √(1/3).
  ControlNet first{};
  first[2][0][0] = first[0][2][1] = 1;
  ControlNet second{};
  second[0][0] = {Rational(2, 5), 0, 0};
  second[1][0][0] = Rational(1, 5);
  second[0][1][1] = Rational(1, 3);
  const BezierPatch x = BezierPatch::from_power_basis(first);
  const BezierPatch y = BezierPatch::from_power_basis(second);
  const auto root = [](const Polynomial& f) {
    return real_roots(f, 0, 1).at(0).refined_to(power_of_two(-200)).interval();
  };
  const ParameterBox box = {root(Polynomial({-3, 0, 5})), root(Polynomial({-1, 0, 3})), {1, 1}, {1, 1}};
  const auto place = algebraic_place(x, y, box);
  REQUIRE(place);
  CHECK(place->modulus.degree() == 4);
  check_root(*place, 0, Polynomial({-3, 0, 5}), box[0]);
  check_root(*place, 1, Polynomial({-1, 0, 3}), box[1]);
}

TEST_CASE("singular points of a curve, its multiple factors taken once") {
  // (u² - 1/2)² = (v² - 1/3)²: crossings where u² = 1/2, v² = 1/3, and where one of u, v is 0.
  const BivariatePolynomial u = BivariatePolynomial::r(), v = BivariatePolynomial::s();
  const auto one = [](const Rational& q) { return BivariatePolynomial::constant(q); };
  const BivariatePolynomial a = u * u - one(Rational(1, 2)), b = v * v - one(Rational(1, 3));
  const auto root = [](const Polynomial& f) {
    return real_roots(f, 0, 1).at(0).refined_to(power_of_two(-60)).interval();
  };
  ParameterBox box = {root(Polynomial({-1, 0, 2})), root(Polynomial({-1, 0, 3})), {1, 1}, {0, 0}};
  for (const BivariatePolynomial& f : {a * a - b * b, (a - b) * (a - b) * (a + b)}) {
    const auto place = algebraic_place(f, box);
    REQUIRE(place);
    CHECK(place->modulus.degree() == 4);
    check_root(*place, 0, Polynomial({-1, 0, 2}), box[0]);
    check_root(*place, 1, Polynomial({-1, 0, 3}), box[1]);
    CHECK((place->at[2] == Polynomial(1) && place->at[3].is_zero()));
  }
  CHECK_FALSE(algebraic_place(a - b, box));  // regular there
  CHECK_FALSE(algebraic_place(BivariatePolynomial(), box));
  box[2].lower = 0;
  CHECK_FALSE(algebraic_place(a * a - b * b, box));
}

}  // namespace exsect::algebraic_place_test
