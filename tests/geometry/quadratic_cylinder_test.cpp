#include <exsect/geometry/quadratic_cylinder.h>

#include <set>

#include "awkward_lines.h"
#include "support/catch.h"

namespace exsect::quadratic_cylinder_test {

namespace {

std::vector<ParameterLine> test_lines(Random& random) {
  std::vector<ParameterLine> lines = awkward_conics();
  for (int i = 0; i < 10; ++i) lines.push_back(random_conic(random));
  return lines;
}

/// The quadric with x, y, z replaced by polynomials in t: its value along a curve.
Polynomial along(const Quadric& quadric, const std::array<Polynomial, 3>& curve) {
  Polynomial sum;
  for (const QuadricTerm& term : quadric.terms()) {
    Polynomial product = term.coefficient;
    for (std::size_t k = 0; k < 3; ++k)
      for (int n = 0; n < term.exponents[k]; ++n) product *= curve[k];
    sum += product;
  }
  return sum;
}

}  // namespace

TEST_CASE("the cylinder contains its line identically", "[quadratic_cylinder]") {
  const auto seed = 22u;
  INFO("seed " << seed);
  Random random(seed);
  for (const ParameterLine& line : test_lines(random)) {
    std::array<Polynomial, 3> curve;
    for (std::size_t k = 0; k < 3; ++k) curve[k] = Polynomial({line.a[0][k], line.a[1][k], line.a[2][k]});
    CHECK(along(quadratic_cylinder(orthogonal_forms(line)), curve).is_zero());
    CHECK(along(quadratic_cylinder(axis_forms(line)), curve).is_zero());
  }
}

TEST_CASE("the explicit quadric is the product of forms, constant along its rulings",
          "[quadratic_cylinder]") {
  const auto seed = 23u;
  INFO("seed " << seed);
  Random random(seed);
  for (const ParameterLine& line : test_lines(random)) {
    const Point n = cross(line.a[1], line.a[2]);
    const LineForms forms = orthogonal_forms(line);
    const Quadric quadric = quadratic_cylinder(forms);
    const Rational big_n = dot(n, n);
    for (int i = 0; i < 5; ++i) {
      const Point p = random_point(random);
      // zeta = w1^2 - N w2
      const Rational w1 = determinant(line.a[2], n, p - line.a[0]);
      const Rational w2 = determinant(n, line.a[1], p - line.a[0]);
      CHECK(quadric(p) == -(w1 * w1 - big_n * w2));
      CHECK(quadric(p + random_rational(random) * n) == quadric(p));
    }
    // A quadric of rank one in degree two: every 2x2 minor of its quadratic part vanishes.
    const auto& c = quadric.coefficients();
    CHECK(c[1] * c[1] == 4 * c[0] * c[3]);
    CHECK(c[2] * c[2] == 4 * c[0] * c[5]);
    CHECK(c[4] * c[4] == 4 * c[3] * c[5]);
  }
}

TEST_CASE("terms name each monomial once and leave out zeros", "[quadratic_cylinder]") {
  // y = x^2 in the plane z = 0, n = (0,0,1): N = 1, w1 = x, w2 = y
  const ParameterLine line = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
  const std::vector<QuadricTerm> terms = quadratic_cylinder(orthogonal_forms(line)).terms();
  REQUIRE(terms.size() == 2);
  CHECK(terms[0].coefficient == -1);
  CHECK(terms[0].exponents == std::array<int, 3>{2, 0, 0});
  CHECK(terms[1].coefficient == 1);
  CHECK(terms[1].exponents == std::array<int, 3>{0, 1, 0});
  CHECK(std::set<std::array<int, 3>>(Quadric::monomials.begin(), Quadric::monomials.end()).size() == 10);
}

TEST_CASE("the bounding planes cut out 0 <= t <= 1", "[quadratic_cylinder]") {
  const auto seed = 24u;
  INFO("seed " << seed);
  Random random(seed);
  for (const ParameterLine& line : test_lines(random)) {
    for (const LineForms& forms : {orthogonal_forms(line), axis_forms(line)}) {
      const BoundingPlanes planes = bounding_planes(forms);
      CHECK(planes.start(line(0)) == 0);
      CHECK(planes.end(line(1)) == 0);
      for (const Rational& t : {Rational(-1, 9), Rational(1, 2), Rational(9, 8), random_rational(random)}) {
        CHECK((planes.start(line(t)) >= 0) == (t >= 0));
        CHECK((planes.end(line(t)) <= 0) == (t <= 1));
      }
    }
    const LineForms forms = orthogonal_forms(line);
    CHECK(bounding_planes(forms).start == forms.e1);
  }
  LineForms forms = orthogonal_forms(awkward_conics()[0]);
  forms.e0.constant = 0;
  CHECK_THROWS_AS(bounding_planes(forms), std::domain_error);
  forms.e0 = {{1, 0, 0}, 1};
  CHECK_THROWS_AS(bounding_planes(forms), std::domain_error);
}

}  // namespace exsect::quadratic_cylinder_test
