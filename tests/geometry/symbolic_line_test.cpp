#include <exsect/geometry/patch_file.h>
#include <exsect/geometry/quadratic_cylinder.h>
#include <exsect/geometry/symbolic_line.h>

#include <algorithm>

#include "random_shapes.h"
#include "support/catch.h"

namespace exsect::symbolic_line_test {

namespace {

using Degrees = std::array<int, 3>;

Degrees degrees(const TrivariatePolynomial& f) { return {f.degree_u(), f.degree_r(), f.degree_s()}; }

int degree_u(const SymbolicForm& form) {
  int degree = form.constant.degree();
  for (const Polynomial& c : form.normal) degree = std::max(degree, c.degree());
  return degree;
}

struct Pair {
  BezierPatch x;
  BezierPatch y;
};

/// Both examples of the chapter and random pairs.
std::vector<Pair> generic_pairs(Random& random) {
  std::vector<Pair> pairs;
  for (const char* name : {"/chapter9-first.json", "/chapter9-second.json"}) {
    const PatchFile file = read_patches(std::string(EXSECT_EXAMPLES) + name);
    pairs.push_back({file.patches[0].patch, file.patches[1].patch});
  }
  for (int i = 0; i < 2; ++i) {
    const BezierPatch x = random_patch(random);
    pairs.push_back({x, random_patch(random)});
  }
  return pairs;
}

}  // namespace

TEST_CASE("degrees in u and bidegrees are those of the chapter", "[symbolic_line]") {
  const auto seed = 29u;
  INFO("seed " << seed);
  Random random(seed);
  for (const auto& [x, y] : generic_pairs(random)) {
    const SymbolicLineForms forms = orthogonal_forms(symbolic_line(x));
    CHECK(degree_u(forms.plane) == 6);
    CHECK(degree_u(forms.e0) == 8);
    CHECK(degree_u(forms.e1) == 8);
    CHECK(degree_u(forms.e2) == 8);
    const SymbolicQuadric cylinder = quadratic_cylinder(forms);
    int degree = -1;
    for (const Polynomial& c : cylinder.coefficients()) degree = std::max(degree, c.degree());
    CHECK(degree == 16);

    const SymbolicPullBack pulled = pull_back(forms, y);
    CHECK(degrees(pulled.plane) == Degrees{6, 2, 2});        // (9.23)
    CHECK(degrees(pulled.cylinder()) == Degrees{16, 4, 4});  // (9.24)
    CHECK(degrees(pulled.u) == Degrees{8, 0, 0});
    CHECK(degrees(pulled.l) == Degrees{8, 2, 2});
    CHECK(degrees(pulled.m) == Degrees{8, 2, 2});
    CHECK(degrees(tangency_determinant(pulled)) == Degrees{18, 5, 5});  // (9.25)
  }
}

TEST_CASE("the symbolic forms at u0 are the forms of the line at u0", "[symbolic_line]") {
  const auto seed = 30u;
  INFO("seed " << seed);
  Random random(seed);
  for (const auto& [x, y] : generic_pairs(random)) {
    const SymbolicLine symbolic = symbolic_line(x);
    const SymbolicLineForms symbolic_forms = orthogonal_forms(symbolic);
    const SymbolicPullBack symbolic_pullback = pull_back(symbolic_forms, y);
    for (const Rational& u0 : {Rational(0), Rational(1), Rational(1, 20), random_rational(random)}) {
      const ParameterLine line = line_at_first(x, u0);
      CHECK(symbolic.at(u0).a == line.a);
      const LineForms forms = orthogonal_forms(line);
      CHECK(at(symbolic_forms, u0) == forms);
      const Quadric quadric = quadratic_cylinder(forms);
      const SymbolicQuadric symbolic_quadric = quadratic_cylinder(symbolic_forms);
      for (std::size_t i = 0; i < 10; ++i)
        CHECK(symbolic_quadric.coefficients()[i](u0) == quadric.coefficients()[i]);
      const Point p = random_point(random);
      CHECK(symbolic_quadric(p)(u0) == quadric(p));
      const PullBack pulled = pull_back(forms, y);
      CHECK(symbolic_pullback.plane.at_u(u0) == pulled.plane);
      CHECK(symbolic_pullback.cylinder().at_u(u0) == pulled.cylinder());
      CHECK(symbolic_pullback.l.at_u(u0) == pulled.l);
    }
  }
}

TEST_CASE("the tangency determinant is the determinant of the tangents", "[symbolic_line]") {
  const auto seed = 31u;
  INFO("seed " << seed);
  Random random(seed);
  for (const auto& [x, y] : generic_pairs(random)) {
    const SymbolicPullBack pulled = pull_back(orthogonal_forms(symbolic_line(x)), y);
    const TrivariatePolynomial tangency = tangency_determinant(pulled);
    for (int i = 0; i < 5; ++i) {
      const Rational u = random_rational(random);
      const Rational r = random_rational(random);
      const Rational s = random_rational(random);
      const auto& [a0, a1, a2] = line_at_first(x, u).a;
      const Point n = cross(a1, a2);
      const Rational big_n = dot(n, n);
      const Rational w1 = determinant(a2, n, y(r, s) - a0);
      const Point tangent = big_n * a1 + Rational(2 * w1) * a2;
      CHECK(tangency.at_u(u)(r, s) ==
            -big_n * determinant(tangent, y.derivative_first(r, s), y.derivative_second(r, s)));
    }
  }
}

TEST_CASE("degrees drop for special patches and straight lines are refused", "[symbolic_line]") {
  const auto seed = 32u;
  INFO("seed " << seed);
  Random random(seed);
  std::vector<std::vector<Point>> linear_in_u(2);
  for (auto& row : linear_in_u)
    for (int j = 0; j < 3; ++j) row.push_back(random_point(random));
  const SymbolicLineForms forms = orthogonal_forms(symbolic_line(BezierPatch::elevated(linear_in_u)));
  CHECK(degree_u(forms.plane) == 3);
  CHECK(degree_u(forms.e0) == 4);
  CHECK(degree_u(forms.e1) == 4);

  const BezierPatch ruled = BezierPatch::elevated({{random_point(random), random_point(random)},
                                                   {random_point(random), random_point(random)},
                                                   {random_point(random), random_point(random)}});
  CHECK_THROWS_AS(orthogonal_forms(symbolic_line(ruled)), std::domain_error);
}

}  // namespace exsect::symbolic_line_test
