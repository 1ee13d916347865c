#include "eliminant/weighted_eliminant.h"

#include <exsect/algebra/resultant.h>
#include <exsect/solver/turning_eliminant.h>

#include <random>

#include "eliminant/stripped_eliminant.h"
#include "eliminant/weighted_pair.h"
#include "exact_products.h"
#include "scalar_eliminant.h"
#include "support/catch.h"
#include "weighted_pairs.h"

namespace exsect::weighted_eliminant_test {
using namespace exsect::weighted_pairs;

namespace {

Polynomial eliminant(const RationalPatch& x, const RationalPatch& y) {
  const auto e = weighted_eliminant(x, y, Parameter::u);
  REQUIRE(e);
  return *e;
}

using Vector = std::array<BivariatePolynomial, 4>;

BivariatePolynomial determinant(const std::array<Vector, 4>& m) {
  BivariatePolynomial sum;
  std::array<std::size_t, 4> p = {0, 1, 2, 3};
  do {
    int inversions = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) inversions += p[i] > p[j] ? 1 : 0;
    const BivariatePolynomial product = m[0][p[0]] * m[1][p[1]] * m[2][p[2]] * m[3][p[3]];
    sum = inversions % 2 == 0 ? sum + product : sum - product;
  } while (std::next_permutation(p.begin(), p.end()));
  return sum;
}

/// E(u) up to a constant factor by its definition: (l_s l_r)^4 times the product of [Y X_v Y_r Y_s] over the
/// fibre, with the cone (16.3), some vector c and exact resultants. Without the points at the roots of
/// `point_lines`, D of (16.19).
Rational by_definition(const RationalPatch& x, const RationalPatch& y, const Rational& u,
                       const Polynomial& point_lines = Polynomial(1)) {
  const PowerBasis power = power_basis(x);
  std::array<Vector, 3> a;
  Vector c, point, along_r, along_s;
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t j = 0; j < 3; ++j)
      a[j][k] = BivariatePolynomial::constant(power[0][j][k] + u * (power[1][j][k] + u * power[2][j][k]));
    c[k] = BivariatePolynomial::constant(Rational(static_cast<long>(3 * k * k + 1), 5));
    point[k] = y.component(static_cast<int>(k));
    along_r[k] = point[k].derivative_r();
    along_s[k] = point[k].derivative_s();
  }
  const BivariatePolynomial e0 = determinant({point, a[1], a[2], c});
  const BivariatePolynomial e1 = determinant({a[0], point, a[2], c});
  const BivariatePolynomial e2 = determinant({a[0], a[1], point, c});
  const BivariatePolynomial plane = determinant({a[0], a[1], a[2], point});
  const BivariatePolynomial cone = e0 * e2 - e1 * e1;
  const Rational gamma = determinant({a[0], a[1], a[2], c}).coefficient(0, 0);
  const Polynomial whole = resultant_r(plane, cone), r_r = resultant_s(plane, cone);
  REQUIRE(whole.degree() == 16);
  REQUIRE(r_r.degree() == 16);
  const Polynomial squared = point_lines * point_lines;
  const auto [r_s, rest] = divide(whole, squared * squared);
  REQUIRE(rest.is_zero());
  Vector e0_x_v;
  for (std::size_t k = 0; k < 4; ++k) e0_x_v[k] = e0 * a[1][k] + e1 * a[2][k] + e1 * a[2][k];
  const testing::Reduced z = testing::reduced(cone, plane);
  // Over the fibre, r = -z.constant / z.linear.
  const auto product = [&, &r_s = r_s](const BivariatePolynomial& f) {
    const testing::Reduced g = testing::reduced(f, plane);
    Rational value = testing::product_over_roots(r_s, g.constant * z.linear - g.linear * z.constant) /
                     testing::product_over_roots(r_s, z.linear);
    const Rational leads = testing::product_over_roots(r_s, plane.coefficient(2));
    for (int i = 0; i < g.power; ++i) value /= leads;
    return value;
  };
  Rational l = r_s.leading_coefficient() * r_r.leading_coefficient();
  for (int i = 0; i < 8; ++i) l /= gamma;
  return product(determinant({point, e0_x_v, along_r, along_s})) / product(e0) * l * l * l * l;
}

RationalPatch polynomial_patch(Random& random) { return eliminant_pairs::random_patch(random); }

/// (f (1 - s^2), 2 f s, g (1 + s^2), h (1 + s^2)) for the quadratics f, g, h in r with these coefficients.
RationalPatch revolved(const std::array<std::array<Rational, 3>, 3>& profile) {
  // In the Bernstein basis 1, s, s^2 have the coefficients (1,1,1), (0,1/2,1), (0,0,1).
  const std::array<std::array<Rational, 3>, 3> circle = {{{Rational(1), Rational(1), Rational(0)},
                                                          {Rational(0), Rational(1), Rational(2)},
                                                          {Rational(1), Rational(1), Rational(2)}}};
  const auto bernstein = [](const std::array<Rational, 3>& c) {
    return std::array<Rational, 3>{c[0], c[0] + c[1] / 2, c[0] + c[1] + c[2]};
  };
  const auto f = bernstein(profile[0]), g = bernstein(profile[1]), h = bernstein(profile[2]);
  std::vector<std::vector<HomogeneousPoint>> net(3);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      net[i].push_back({f[i] * circle[0][j], f[i] * circle[1][j], g[i] * circle[2][j], h[i] * circle[2][j]});
  return RationalPatch::from_homogeneous(net);
}

RationalPatch revolved() {
  return revolved({{{Rational(2), Rational(1, 3), Rational(1, 5)},
                    {Rational(0), Rational(2), Rational(-1, 3)},
                    {Rational(1), Rational(1, 4), Rational(1, 7)}}});
}

/// No coefficient is zero, and the Bernstein coefficients of the weight are positive.
RationalPatch revolved(Random& random) {
  const auto number = [&] { return small_rational(random) + Rational(1, 17); };
  return revolved({{{number(), number(), number()},
                    {number(), number(), number()},
                    {Rational(4), number() / 4, number() / 4}}});
}

}  // namespace

TEST_CASE("weighted eliminant: 160 simple roots, also with weights on one patch alone",
          "[weighted_eliminant]") {
  Random random(41);
  const RationalPatch x = weighted_patch(random), y = weighted_patch(random), z = polynomial_patch(random);
  for (const Polynomial& e : {eliminant(x, y), eliminant(x, z), eliminant(z, y)}) {
    CHECK(e.degree() == 160);
    CHECK(squarefree_part(e).degree() == 160);
    CHECK(e == e.primitive());
    CHECK(sign(e.leading_coefficient()) > 0);
  }
}

TEST_CASE("weighted eliminant: its definition at rational u", "[weighted_eliminant]") {
  Random random(42);
  const RationalPatch x = weighted_patch(random), y = weighted_patch(random);
  const Polynomial e = eliminant(x, y);
  const Rational ratio = by_definition(x, y, 0) / e(0);
  CHECK(ratio != 0);
  for (const Rational& u : {Rational(1), Rational(-3), Rational(5, 7)})
    CHECK(by_definition(x, y, u) == ratio * e(u));
}

TEST_CASE("weighted eliminant: maps of space and of the other parameters change nothing",
          "[weighted_eliminant]") {
  Random random(43);
  const RationalPatch x = weighted_patch(random), y = weighted_patch(random);
  const Polynomial e = eliminant(x, y);
  const auto times = [](const HomogeneousPoint& p) {
    return HomogeneousPoint{7 * p[0], 7 * p[1], 7 * p[2], 7 * p[3]};
  };
  CHECK(eliminant(mapped(x, projective), mapped(y, projective)) == e);
  CHECK(eliminant(mapped(x, times), y) == e);
  CHECK(eliminant(x, y.transposed()) == e);
  CHECK(eliminant(x, y.restricted_to(1, 0, 0, 1)) == e);
  CHECK(eliminant(x.restricted_to(0, 1, Rational(1, 3), 1), y.restricted_to(0, Rational(1, 2), 0, 1)) == e);
  const Polynomial reversed = e.compose(Polynomial(1) - Polynomial::variable());
  CHECK(eliminant(x.restricted_to(1, 0, 0, 1), y) ==
        (sign(reversed.leading_coefficient()) < 0 ? -reversed : reversed));
}

TEST_CASE("weighted eliminant: of a polynomial pair (4.8) times a square", "[weighted_eliminant]") {
  Random random(44);
  const BezierPatch x = eliminant_pairs::random_patch(random), y = eliminant_pairs::random_patch(random);
  const Polynomial e = eliminant(mapped(x, projective), mapped(y, projective));
  const auto polynomial = turning_eliminant(x, y).polynomial;
  REQUIRE(polynomial);
  CHECK(e.degree() == 144);
  const auto [quotient, remainder] = divide(e, *polynomial);
  CHECK(remainder == Polynomial(0));
  CHECK(squarefree_part(quotient).degree() == 8);  // g_r g_s
}

TEST_CASE("weighted eliminant: surfaces of revolution", "[weighted_eliminant]") {
  Random random(45);
  const RationalPatch x = revolved().transposed(), y = weighted_patch(random);
  Polynomial e = eliminant(x, y);
  CHECK(e.degree() == 160);
  const Polynomial circle({1, 0, 1});
  for (int i = 0; i < 32; ++i) {
    const auto [quotient, remainder] = divide(e, circle);
    REQUIRE(remainder == Polynomial(0));
    e = quotient;
  }
  CHECK(squarefree_part(e).degree() == 96);
  CHECK(weighted_eliminant(y, x, Parameter::u));  // (16.20): every fibre has Y = 0 at s = i and -i
  CHECK_FALSE(weighted_eliminant(x, x, Parameter::u));
}

TEST_CASE("weighted eliminant: of surfaces of revolution by its definition", "[weighted_eliminant]") {
  const auto seed = std::random_device{}();
  CAPTURE(seed);
  Random random(seed);
  for (int repeat = 0; repeat < 3; ++repeat) {
    const RationalPatch x = weighted_patch(random);
    const RationalPatch y = mapped(revolved(random), projective).restricted_to(0, 1, Rational(repeat, 5), 1);
    const Polynomial circle = point_lines(weighted_pair(x, y).y);
    REQUIRE(circle.degree() == 2);
    const Polynomial e = eliminant(x, y);
    CHECK(e.degree() <= 160);
    const Rational ratio = by_definition(x, y, 0, circle) / e(0);
    CHECK(ratio != 0);
    for (const Rational& u : {Rational(-3), Rational(5, 7)})
      CHECK(by_definition(x, y, u, circle) == ratio * e(u));
  }
}

TEST_CASE("weighted eliminant: vectors and scalars, and the bound of the height", "[weighted_eliminant]") {
  const auto seed = std::random_device{}();
  CAPTURE(seed);
  Random random(seed);
  for (int repeat = 0; repeat < 3; ++repeat) {
    const WeightedPair pair = repeat == 2 ? weighted_pair(weighted_doubles(random), weighted_doubles(random))
                                          : weighted_pair(weighted_patch(random), weighted_patch(random));
    scalar_eliminant::check_vectors_and_bound(pair, 1200);
  }
}

TEST_CASE("weighted eliminant: enclosed roots are those of the exact one", "[weighted_eliminant]") {
  const auto seed = std::random_device{}();
  CAPTURE(seed);
  Random random(seed);
  std::size_t decided = 0, count = 0;
  for (int repeat = 0; repeat < 6; ++repeat) {
    const bool doubles = repeat % 2 == 0;
    const RationalPatch x = doubles ? weighted_doubles(random) : weighted_patch(random);
    const RationalPatch y = doubles ? weighted_doubles(random) : weighted_patch(random);
    const auto roots = scalar_eliminant::checked_roots(x, y);
    decided += roots ? 1 : 0;
    count += roots.value_or(0);
  }
  CHECK(decided >= 5);
  CHECK(count >= 1);
}

}  // namespace exsect::weighted_eliminant_test
