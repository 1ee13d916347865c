// The eliminant of surfaces of revolution against their equations.
#include "eliminant/stripped_eliminant.h"

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/resultant.h>

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
