#include <exsect/geometry/patch_file.h>
#include <exsect/geometry/pull_back.h>

#include "awkward_lines.h"
#include "support/catch.h"

namespace exsect::pull_back_test {

TEST_CASE("the forms are 0 and 1 : t : t^2 on their line", "[pull_back]") {
  const auto seed = 7u;
  INFO("seed " << seed);
  Random random(seed);
  std::vector<ParameterLine> lines = awkward_conics();
  for (int i = 0; i < 20; ++i) lines.push_back(random_conic(random));
  for (const ParameterLine& line : lines) {
    for (const LineForms& forms : {orthogonal_forms(line), axis_forms(line)}) {
      for (const Rational& t :
           {Rational(0), Rational(1), Rational(1, 3), Rational(-7), random_rational(random)}) {
        const Point p = line(t);
        const Rational n = forms.e0(p);
        CHECK(n != 0);
        CHECK(forms.plane(p) == 0);
        CHECK(forms.e1(p) == n * t);
        CHECK(forms.e2(p) == n * t * t);
      }
    }
  }
}

TEST_CASE("the forms are the formulas of the method", "[pull_back]") {
  const auto seed = 8u;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 20; ++round) {
    const ParameterLine line = random_conic(random);
    const auto& [a0, a1, a2] = line.a;
    const Point n = cross(a1, a2);
    const Point w = random_point(random);
    const LineForms orthogonal = orthogonal_forms(line);
    CHECK(orthogonal.plane(a0 + w) == dot(n, w));
    CHECK(orthogonal.e0(w) == dot(n, n));
    CHECK(orthogonal.e1(a0 + w) == determinant(a2, n, w));
    CHECK(orthogonal.e2(a0 + w) == determinant(n, a1, w));
    const LineForms axis = axis_forms(line);
    std::size_t k = 0;
    while (axis.e0.constant != n[k]) ++k;
    CHECK(abs(n[k]) >= abs(n[(k + 1) % 3]));
    CHECK(abs(n[k]) >= abs(n[(k + 2) % 3]));
    CHECK(axis.plane == orthogonal.plane);
    CHECK(axis.e1(a0 + w) == cross(w, a2)[k]);
    CHECK(axis.e2(a0 + w) == cross(a1, w)[k]);
  }
}

TEST_CASE("a line that is not a conic has no forms", "[pull_back]") {
  const Point p = {1, 2, 3};
  const Point zero = {0, 0, 0};
  for (const ParameterLine& line :
       {ParameterLine{{p, zero, zero}}, ParameterLine{{p, p, zero}},
        ParameterLine{{zero, p, Rational(-2) * p}}, ParameterLine{{zero, zero, p}}}) {
    CHECK_THROWS_AS(orthogonal_forms(line), std::domain_error);
    CHECK_THROWS_AS(axis_forms(line), std::domain_error);
  }
}

TEST_CASE("pulling back is evaluating on the patch", "[pull_back]") {
  const auto seed = 9u;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 10; ++round) {
    const LineForms forms =
        round % 2 == 0 ? axis_forms(random_conic(random)) : orthogonal_forms(random_conic(random));
    const BezierPatch y = random_patch(random);
    const PullBack pulled = pull_back(forms, y);
    CHECK(pulled.plane.degree_r() <= 2);
    CHECK(pulled.plane.degree_s() <= 2);
    const BivariatePolynomial z = pulled.cylinder();
    CHECK(z.degree_r() <= 4);
    CHECK(z.degree_s() <= 4);
    for (int i = 0; i < 5; ++i) {
      const Rational r = random_rational(random);
      const Rational s = random_rational(random);
      const Point p = y(r, s);
      CHECK(pulled.plane(r, s) == forms.plane(p));
      CHECK(pulled.u(r, s) == forms.e0(p));
      CHECK(pulled.l(r, s) == forms.e1(p));
      CHECK(pulled.m(r, s) == forms.e2(p));
      CHECK(z(r, s) == forms.e0(p) * forms.e2(p) - forms.e1(p) * forms.e1(p));
    }
  }
}

TEST_CASE("a patch in the plane of the line pulls the plane back to zero", "[pull_back]") {
  const BezierPatch flat = BezierPatch::elevated({{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}}});
  const ParameterLine line = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
  const PullBack pulled = pull_back(axis_forms(line), flat);
  CHECK(pulled.plane.is_zero());
  // the parabola y = x^2 in the square's own coordinates (r,s) = (x,y)
  CHECK(pulled.cylinder() == BivariatePolynomial::s() - BivariatePolynomial::r() * BivariatePolynomial::r());
}

TEST_CASE("the first example pulls back to bidegrees (2,2) and (4,4)", "[pull_back]") {
  const PatchFile file = read_patches(EXSECT_EXAMPLES "/chapter9-first.json");
  for (const Rational& u0 : {Rational(1, 20), Rational(2, 25), Rational(1, 2)}) {
    const ParameterLine line = line_at_first(file.patches[0].patch, u0);
    REQUIRE(shape(line) == LineShape::conic);
    for (const LineForms& forms : {orthogonal_forms(line), axis_forms(line)}) {
      const PullBack pulled = pull_back(forms, file.patches[1].patch);
      CHECK(pulled.plane.degree_r() == 2);
      CHECK(pulled.plane.degree_s() == 2);
      CHECK(pulled.cylinder().degree_r() == 4);
      CHECK(pulled.cylinder().degree_s() == 4);
    }
  }
}

}  // namespace exsect::pull_back_test
