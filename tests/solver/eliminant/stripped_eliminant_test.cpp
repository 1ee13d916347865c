// The eliminant of surfaces of revolution against their equations.
#include "eliminant/stripped_eliminant.h"

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/fixed_point_interval.h>
#include <exsect/algebra/resultant.h>

#include <random>

#include "eliminant/special_eliminant.h"
#include "eliminant/weighted_eliminant.h"
#include "eliminant/weighted_eliminant_height.h"
#include "solver/filter/round_patches.h"
#include "support/catch.h"
#include "support/random_nets.h"
#include "weighted_pairs.h"

namespace exsect::stripped_eliminant_test {
namespace {

using namespace exsect::weighted_pairs;

/// The product of the factors of multiplicity one.
Polynomial simple_factor(const Polynomial& f) {
  const auto factors = squarefree_factors(f);
  const bool has_any = !factors.empty() && factors.front().multiplicity == 1;
  return has_any ? primitive_with_positive_lead(factors.front().factor) : Polynomial(1);
}

/// (x^2 + y^2 + z^2 + 3)^2 - 16 (x^2 + y^2), of torus(2, 1), on a patch.
BivariatePolynomial torus_equation(const RationalPatch& x) {
  const auto square = [](const BivariatePolynomial& f) { return f * f; };
  const BivariatePolynomial axial = square(x.component(0)) + square(x.component(1));
  const BivariatePolynomial weight = square(x.component(3));
  return square(axial + square(x.component(2)) + BivariatePolynomial::constant(3) * weight) -
         BivariatePolynomial::constant(16) * axial * weight;
}

RationalPatch small_patch(random_nets::Generator& generator, int m, int n) {
  return random_nets::weighted(generator, random_nets::small(generator, m, n));
}

/// Lines (f, g, h, w) + ... of r, turned about an axis by an angle with the circular points s = i, -i.
RationalPatch ruled_and_revolved(Random& random) {
  const std::array<Polynomial, 3> circle = {Polynomial({1, 0, -1}), Polynomial({0, 2}),
                                            Polynomial({1, 0, 1})};
  const auto number = [&] { return small_rational(random) + Rational(1, 17); };  // not zero
  PowerBasis net(2, std::vector<HomogeneousPoint>(3));
  for (std::size_t i = 0; i < 2; ++i) {
    const Rational f = number(), g = number();
    const std::array<Polynomial, 4> point = {circle[0] * f - circle[1] * g, circle[1] * f + circle[0] * g,
                                             circle[2] * number(),
                                             circle[2] * (i == 0 ? Rational(4) : number())};
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 4; ++k) net[i][j][k] = point[k].coefficient(static_cast<int>(j));
  }
  return random_nets::image(from_power_basis(net), {{{1, Rational(1, 3), 0, 0},
                                                     {0, 1, Rational(-1, 5), 0},
                                                     {0, 0, 1, 1},
                                                     {Rational(1, 16), Rational(1, 16), 0, 1}}});
}

/// [a0 a1 y0 y1] for x = a0 + a1 v, y = y0 + y1 r: a polynomial in u, as the second variable, and s.
BivariatePolynomial common_lines(const RationalPatch& x, const RationalPatch& y) {
  using Row = std::array<BivariatePolynomial, 4>;
  const PowerBasis a = power_basis(x), b = power_basis(y);
  std::array<Row, 4> rows;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t line = 0; line < 2; ++line) {
      std::vector<Rational> along_u, along_s;
      for (const auto& row : a) along_u.push_back(row[line][k]);
      for (const HomogeneousPoint& c : b[line]) along_s.push_back(c[k]);
      rows[line][k] = BivariatePolynomial({Polynomial(along_u)});
      rows[2 + line][k] = BivariatePolynomial({Polynomial(along_s)}).exchanged();
    }
  const auto minor = [&](std::size_t i, std::size_t k, std::size_t l) {
    return rows[i][k] * rows[i + 1][l] - rows[i][l] * rows[i + 1][k];
  };
  return minor(0, 0, 1) * minor(2, 2, 3) - minor(0, 0, 2) * minor(2, 1, 3) + minor(0, 0, 3) * minor(2, 1, 2) +
         minor(0, 1, 2) * minor(2, 0, 3) - minor(0, 1, 3) * minor(2, 0, 2) + minor(0, 2, 3) * minor(2, 0, 1);
}

}  // namespace

TEST_CASE("stripped eliminant: lines that are points", "[stripped_eliminant]") {
  random_nets::Generator generator(1);
  const RationalPatch x = small_patch(generator, 2, 2), torus = testing::torus(2, 1);
  CHECK(point_lines(weighted_pair(torus, x).y).degree() == 0);
  // The second parameter of torus() is the angle about the axis: its two circular points.
  const Polynomial circular = point_lines(weighted_pair(x, torus).y);
  CHECK(circular.degree() == 2);
  CHECK(sign(circular.coefficient(1) * circular.coefficient(1) -
             4 * circular.coefficient(0) * circular.coefficient(2)) < 0);
  CHECK(circular == point_lines(weighted_pair(x, testing::sphere(3)).y));
  CHECK_FALSE(stripped_eliminant(weighted_pair(torus, x), 1000));  // the torus alone has such lines
}

TEST_CASE("stripped eliminant: the simple roots of the equation's discriminant are among its roots",
          "[stripped_eliminant]") {
  const RationalPatch torus = testing::torus(2, 1);
  for (const auto& [m, n, degree] :
       {std::array{1, 1, 14}, std::array{1, 2, 32}, std::array{1, 3, 48}, std::array{2, 2, 80}}) {
    CAPTURE(m, n);
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      INFO("seed " << seed);
      random_nets::Generator generator(seed);
      const RationalPatch x = small_patch(generator, m, n);
      const auto e = weighted_eliminant(x, torus, Parameter::v);
      REQUIRE(e);
      const Polynomial turning = simple_factor(discriminant_r(torus_equation(x)));
      CHECK(turning.degree() == degree);
      CHECK(divide(*e, turning).remainder.is_zero());
      const auto transposed = weighted_eliminant(x, torus.transposed(), Parameter::v);
      REQUIRE(transposed);
      CHECK(divide(*transposed, turning).remainder.is_zero());
      if (m == 2) CHECK(simple_factor(*e) == turning);
    }
  }
}

TEST_CASE("stripped eliminant: of two ruled patches by its definition", "[stripped_eliminant]") {
  const auto seed = std::random_device{}();
  CAPTURE(seed);
  Random random(seed);
  random_nets::Generator generator(seed);
  for (int degree = 1; degree <= 3; ++degree) {
    CAPTURE(degree);
    const RationalPatch x = small_patch(generator, degree, 1), y = ruled_and_revolved(random);
    const WeightedPair pair = weighted_pair(x, y);
    const Polynomial circle = point_lines(pair.y);
    REQUIRE(circle == Polynomial({1, 0, 1}));
    const BivariatePolynomial points = BivariatePolynomial({circle}).exchanged();
    const BivariatePolynomial moving = exact_quotient(common_lines(x, y), points);
    CHECK(moving.degree_r() == 2);
    const Polynomial fixed = resultant_r(moving, points), defined = discriminant_r(moving) * fixed;
    const auto e = stripped_eliminant(pair, eliminant_height_bound(pair));
    REQUIRE(e);
    CHECK(primitive_with_positive_lead(polynomial_of(chinese_remainder(*e))) ==
          primitive_with_positive_lead(defined));
    // The fixed roots are simple ones of R: (16.16) is defined as well.
    CHECK(weighted_eliminant(x, y, Parameter::u) == primitive_with_positive_lead(defined * fixed));
  }
}

TEST_CASE("stripped eliminant: the bound of the height", "[stripped_eliminant]") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    INFO("seed " << seed);
    random_nets::Generator generator(seed);
    const WeightedPair pair = weighted_pair(small_patch(generator, 2, 2), testing::torus(2, 1));
    const std::size_t bound = eliminant_height_bound(pair);
    const auto e = stripped_eliminant(pair, bound), more = stripped_eliminant(pair, bound + 200);
    REQUIRE(e);
    REQUIRE(more);
    CHECK(chinese_remainder(*e) == chinese_remainder(*more));
  }
}

}  // namespace exsect::stripped_eliminant_test
