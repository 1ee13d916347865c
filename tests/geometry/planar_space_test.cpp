#include <exsect/geometry/planar_space.h>

#include "curve_specimens.h"
#include "support/catch.h"

namespace exsect::planar_space_test {

namespace {

const PlanarBox box = {{Rational(0), Rational(2)}, {Rational(-1), Rational(1)}};

std::vector<Rational> random_coefficients(Random& random, std::size_t count) {
  std::vector<Rational> c;
  for (std::size_t i = 0; i < count; ++i) c.push_back(random_rational(random));
  return c;
}

PlanarSpace splines(int m, int n) {
  const BezierCurve curve({{0, -1}, {1, Rational(1, 2)}, {2, 1}});
  return PlanarSpace::b_splines(m, n, box, 6, 5, curve);
}

/// The tension of a polynomial on the box, by integrating its second derivatives.
Rational tension_of(const BivariatePolynomial& f) {
  const auto integral = [](const BivariatePolynomial& g) {
    Rational sum = 0;
    for (int i = 0; i <= g.degree_r(); ++i) {
      for (int j = 0; j <= g.degree_s(); ++j) {
        const auto power = [](const Rational& t, int k) {
          Rational p = 1;
          for (int l = 0; l < k; ++l) p *= t;
          return p;
        };
        const Rational in_x = (power(box.x.upper, i + 1) - power(box.x.lower, i + 1)) / (i + 1);
        const Rational in_y = (power(box.y.upper, j + 1) - power(box.y.lower, j + 1)) / (j + 1);
        sum += g.coefficient(i, j) * in_x * in_y;
      }
    }
    return sum;
  };
  const BivariatePolynomial xx = f.derivative_r().derivative_r(), xy = f.derivative_r().derivative_s(),
                            yy = f.derivative_s().derivative_s();
  return integral(xx * xx) + 2 * integral(xy * xy) + integral(yy * yy);
}

Rational quadratic_form(const RationalMatrix& h, const std::vector<Rational>& c) {
  Rational sum = 0;
  for (std::size_t i = 0; i < c.size(); ++i)
    for (std::size_t j = 0; j < c.size(); ++j) sum += c[i] * h(i, j) * c[j];
  return sum;
}

}  // namespace

TEST_CASE("spaces have the dimensions of the theory", "[planar_space]") {
  CHECK(PlanarSpace::monomials(0, box).dimension() == 1);
  CHECK(PlanarSpace::monomials(4, box).dimension() == 15);
  CHECK(PlanarSpace::bernstein(2, 3, box).dimension() == 12);
  const PlanarSpace spline = splines(2, 2);
  CHECK(spline.dimension() < 8u * 7u);
  CHECK(spline.dimension() > 20u);
  CHECK_FALSE(spline.is_polynomial());
  CHECK_THROWS_AS(PlanarSpace::monomials(-1, box), std::invalid_argument);
  CHECK_THROWS_AS(PlanarSpace::bernstein(1, 1, {{Rational(0), Rational(0)}, box.y}), std::invalid_argument);
  CHECK_THROWS_AS(splines(1, 2), std::invalid_argument);
  CHECK_THROWS_AS(spline.combination({1}), std::invalid_argument);
}

TEST_CASE("values of the functions are those of their combination", "[planar_space]") {
  const auto seed = 62u;
  INFO("seed " << seed);
  Random random(seed);
  const PlanarSpace spaces[] = {PlanarSpace::monomials(3, box), PlanarSpace::bernstein(3, 2, box),
                                splines(2, 3), PlanarSpace::monomials(2, box).in_squares(),
                                splines(2, 2).in_squares()};
  for (const PlanarSpace& space : spaces) {
    const std::vector<Rational> c = random_coefficients(random, space.dimension());
    const PlanarFunction f = space.combination(c);
    for (const auto& [x, y] : {std::pair<Rational, Rational>(0, -1),
                               {Rational(3, 7), Rational(-1, 2)},
                               {1, Rational(1, 5)},
                               {Rational(4, 3), Rational(2, 3)}}) {
      if (!f(x, y)) continue;
      const PlanarSpace::Values values = space.at(x, y);
      Rational value = 0, dx = 0, dy = 0;
      for (std::size_t i = 0; i < c.size(); ++i) {
        value += c[i] * values.value[i];
        dx += c[i] * values.dx[i];
        dy += c[i] * values.dy[i];
      }
      const BivariatePolynomial there = f.polynomials_on({{x, x}, {y, y}}).front();
      CHECK(there(x, y) == value);
      CHECK(there.derivative_r()(x, y) == dx);
      CHECK(there.derivative_s()(x, y) == dy);
    }
  }
}

TEST_CASE("splines join smoothly, sum to one, and end where cells are left out", "[planar_space]") {
  const PlanarSpace space = splines(2, 2);
  const PlanarFunction one = space.combination(std::vector<Rational>(space.dimension(), 1));
  for (const auto& row : one.cells())
    for (const auto& cell : row)
      if (cell) CHECK(*cell == BivariatePolynomial::constant(1));
  Random random(63);
  const PlanarFunction f = space.combination(random_coefficients(random, space.dimension()));
  const Rational x = f.grid().breaks_x[3];
  int joints = 0;
  for (std::size_t j = 0; j < f.cells()[2].size(); ++j) {
    if (!f.cells()[2][j] || !f.cells()[3][j]) continue;
    ++joints;
    CHECK(f.cells()[2][j]->at_r(x) == f.cells()[3][j]->at_r(x));
    CHECK(f.cells()[2][j]->derivative_r().at_r(x) == f.cells()[3][j]->derivative_r().at_r(x));
    CHECK_FALSE(*f.cells()[2][j] == *f.cells()[3][j]);
  }
  CHECK(joints > 0);
  CHECK_FALSE(f(2, -1).has_value());  // far from the curve
  CHECK_FALSE(f(3, 0).has_value());
  CHECK_THROWS_AS(space.at(2, -1), std::domain_error);
  CHECK(f.polynomials_on({{Rational(0), Rational(2)}, {Rational(-1), Rational(1)}}).empty());
}

TEST_CASE("the tension is the integral of the second derivatives", "[planar_space]") {
  Random random(64);
  for (const PlanarSpace& space : {PlanarSpace::monomials(3, box), PlanarSpace::bernstein(2, 3, box)}) {
    const std::vector<Rational> c = random_coefficients(random, space.dimension());
    CHECK(quadratic_form(space.tension(), c) == tension_of(space.combination(c).polynomial()));
  }
  // A spline on one cell is a polynomial there.
  const BezierCurve curve({{0, 0}, {1, 0}});
  const PlanarSpace one_cell = PlanarSpace::b_splines(2, 2, box, 1, 1, curve);
  const std::vector<Rational> c = random_coefficients(random, one_cell.dimension());
  CHECK(quadratic_form(one_cell.tension(), c) == tension_of(one_cell.combination(c).polynomial()));
}

TEST_CASE("the parts of a curve lie in their boxes", "[planar_space]") {
  const HomogeneousCurve circle = homogeneous(quarter_circle());
  const PlanarBox all = control_box(circle, 0, 1);
  CHECK(all.x.lower == 0);
  CHECK(all.x.upper == 1);
  const PlanarBox part = control_box(circle, Rational(1, 4), Rational(1, 2));
  const std::vector<Rational> p = quarter_circle()(Rational(1, 3));
  CHECK(part.x.lower <= p[0]);
  CHECK(p[0] <= part.x.upper);
  CHECK(part.x.width() < Rational(3, 5));
}

}  // namespace exsect::planar_space_test
