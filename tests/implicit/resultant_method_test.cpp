#include <exsect/algebra/determinant.h>
#include <exsect/geometry/patch_file.h>
#include <exsect/implicit/resultant_method.h>

#include <algorithm>

#include "support/catch.h"

namespace exsect::resultant_method_test {
namespace {

struct Patches {
  BezierPatch x;
  BezierPatch y;
};
Patches example(const std::string& name) {
  const PatchFile file = read_patches(std::string(EXSECT_EXAMPLES) + "/" + name);
  return {file.patches[0].patch, file.patches[1].patch};
}

struct Shapes {
  std::ptrdiff_t open, closed, branched;
  friend bool operator==(const Shapes&, const Shapes&) = default;
};
Shapes shapes(const std::vector<CurveComponent>& components) {
  const auto count = [&](auto property) {
    return std::count_if(components.begin(), components.end(), property);
  };
  return {count([](const CurveComponent& c) { return !c.closed && !c.branched; }),
          count([](const CurveComponent& c) { return c.closed; }),
          count([](const CurveComponent& c) { return c.branched; })};
}

/// Sylvester's determinant of the three quadratics without mixed terms x(u,v) - y(r,s) in (v,s): with the
/// rows f, and the derivatives of their Jacobian J with respect to the homogeneous variables v, s, w, in the
/// monomials v^2, s^2, w^2, vs, vw, sw.
Rational sylvester_six(const BezierPatch& x, const BezierPatch& y, const Rational& u, const Rational& r) {
  const ControlNet cx = x.power_basis(), cy = y.power_basis();
  const auto line = [](const ControlNet& c, const Rational& t, std::size_t j) {
    return c[0][j] + t * c[1][j] + (t * t) * c[2][j];
  };
  const Point a2 = line(cx, u, 2), a1 = line(cx, u, 1), b2 = line(cy, r, 2), b1 = line(cy, r, 1);
  const Point a0 = line(cx, u, 0) - line(cy, r, 0);
  // f = a2 v^2 + a1 v w + a0 w^2 - b2 s^2 - b1 s w; J = det(f_v, f_s, f_w) with
  // f_v = 2 a2 v + a1 w, f_s = -2 b2 s - b1 w, f_w = a1 v - b1 s + 2 a0 w.
  using Linear = std::array<Rational, 3>;  // coefficients of v, s, w
  std::array<std::array<Linear, 3>, 3> d;
  for (std::size_t k = 0; k < 3; ++k) {
    d[0][k] = {2 * a2[k], 0, a1[k]};
    d[1][k] = {0, -2 * b2[k], -b1[k]};
    d[2][k] = {a1[k], -b1[k], 2 * a0[k]};
  }
  Rational cubic[3][3][3] = {};
  const int permutations[6][4] = {{0, 1, 2, 1},  {1, 2, 0, 1},  {2, 0, 1, 1},
                                  {0, 2, 1, -1}, {2, 1, 0, -1}, {1, 0, 2, -1}};
  for (const auto& p : permutations)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k)
          cubic[i][j][k] += p[3] * d[0][static_cast<std::size_t>(p[0])][i] *
                            d[1][static_cast<std::size_t>(p[1])][j] * d[2][static_cast<std::size_t>(p[2])][k];
  const std::array<std::array<std::size_t, 2>, 6> monomials = {
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  std::vector<std::vector<BivariatePolynomial>> matrix(6, std::vector<BivariatePolynomial>(6));
  const auto put = [&](std::size_t row, std::size_t column, const Rational& value) {
    matrix[row][column] = BivariatePolynomial::constant(value);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::array<Rational, 6> f = {a2[k], -b2[k], a0[k], 0, a1[k], -b1[k]};
    for (std::size_t column = 0; column < 6; ++column) put(k, column, f[column]);
    for (std::size_t column = 0; column < 6; ++column) {
      const auto [m, n] = monomials[column];
      Rational value = 0;  // of x_m x_n in dJ/dx_k: the sum over places of k, m, n in the cubic
      std::array<std::size_t, 3> places = {k, m, n};
      std::sort(places.begin(), places.end());
      int times_k = 0;
      for (const std::size_t place : places) times_k += place == k ? 1 : 0;
      do value += cubic[places[0]][places[1]][places[2]];
      while (std::next_permutation(places.begin(), places.end()));
      put(3 + k, column, times_k * value);
    }
  }
  return determinant(matrix)(0, 0);
}

TEST_CASE("the resultant is Sylvester's 6 x 6 determinant", "[resultant_method]") {
  const auto [x, y] = example("chapter9-first.json");
  const ResultantMethod method = intersect_by_resultant(x, y);
  CHECK(shapes(method.components) == Shapes{1, 1, 0});
  CHECK(method.phantoms.size() == 3);
  CHECK(method.curve.degree_r() == 16);
  CHECK(method.curve.degree_s() == 16);
  CHECK(method.curve.total_degree() == 24);
  const Rational factor =
      sylvester_six(x, y, Rational(1, 3), Rational(2, 5)) / method.curve(Rational(1, 3), Rational(2, 5));
  CHECK(factor != 0);
  for (const auto& [u, r] : {std::array<Rational, 2>{Rational(1, 7), 2}, {-1, Rational(3, 4)}, {0, 0}})
    CHECK(sylvester_six(x, y, u, r) == factor * method.curve(u, r));
}

TEST_CASE("the resultant method finds the components of the examples", "[resultant_method]") {
  const auto solve = [](const std::string& name) {
    const auto [x, y] = example(name);
    const ResultantMethod method = intersect_by_resultant(x, y);
    INFO(name);
    CHECK_FALSE(method.incomplete);
    const std::vector<CheckLine> lines = check_lines(x, y, 4);
    std::size_t points = 0;
    for (const CheckLine& line : lines) points += line.points.size();
    CHECK(check(method, lines).points == points);
    return method;
  };
  const ResultantMethod second = solve("chapter9-second.json");
  CHECK(shapes(second.components) == Shapes{3, 0, 0});
  const ResultantMethod touching = solve("touching-curve.json");
  CHECK(shapes(touching.components) == Shapes{1, 0, 0});
}

TEST_CASE("a patch and itself have no resultant", "[resultant_method]") {
  const auto [x, y] = example("chapter9-first.json");
  CHECK(intersect_by_resultant(x, x).incomplete);
}

TEST_CASE("check lines are equally spaced and exact", "[resultant_method]") {
  const auto [x, y] = example("chapter9-first.json");
  CHECK_THROWS_AS(check_lines(x, y, 0), std::invalid_argument);
  const std::vector<CheckLine> lines = check_lines(x, y, 2);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].u == Rational(1, 4));
  CHECK(lines[0].points.size() == 2);
  CHECK(lines[1].points.empty());
  CHECK(lines[0].eliminant_roots >= 2);
}

}  // namespace
}  // namespace exsect::resultant_method_test
