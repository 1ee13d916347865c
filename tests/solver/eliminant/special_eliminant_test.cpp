#include "eliminant/special_eliminant.h"

#include <exsect/geometry/integer_pair.h>

#include <string>
#include <vector>

#include "eliminant_pairs.h"
#include "support/catch.h"

namespace exsect::special_eliminant_test {
using namespace exsect::eliminant_pairs;

namespace {

BezierPatch patch(const ControlNet& c) { return BezierPatch::from_power_basis(c); }

BezierPatch of_degree(Random& random, std::size_t m, std::size_t n) {
  return patch(random_coefficients(random, m, n));
}

BezierPatch planar(Random& random) {
  ControlNet c = random_net(random);
  for (auto& row : c)
    for (auto& point : row) point[2] = point[0] - 2 * point[1];
  return patch(c);
}

BezierPatch without(ControlNet c, const std::vector<std::array<std::size_t, 2>>& terms) {
  for (const auto& [i, j] : terms) c[i][j] = Point{};
  return patch(c);
}

/// The coefficient of r^degree has a fixed direction: polynomial(s) * vector.
BezierPatch fixed_direction(Random& random, std::size_t degree) {
  ControlNet c = random_coefficients(random, degree, 2);
  for (std::size_t j = 1; j < 3; ++j) c[degree][j] = small_rational(random) * c[degree][0];
  return patch(c);
}

/// x = curve(u) + v (0,0,1).
BezierPatch vertical_wall(Random& random) {
  ControlNet c = random_coefficients(random, 2, 0);
  c[0][1] = {Rational(0), Rational(0), Rational(1)};
  return patch(c);
}

/// The coefficient of r^degree is vertical at s = 1/2.
BezierPatch vertical_ruling(Random& random, std::size_t degree) {
  ControlNet c = random_coefficients(random, degree, 1);
  for (std::size_t k = 0; k < 2; ++k) c[degree][0][k] = -c[degree][1][k] / 2;
  return patch(c);
}

BezierPatch height_field(Random& random) { return patch(height_field_coefficients(random)); }

/// Coordinate 0 odd in the second parameter, the others even.
BezierPatch mirror_symmetric(Random& random) {
  ControlNet c = random_net(random);
  for (auto& row : c)
    for (std::size_t j = 0; j < 3; ++j) {
      if (j % 2 == 0) row[j][0] = 0;
      if (j % 2 == 1) row[j][1] = row[j][2] = 0;
    }
  return patch(c);
}

struct Shape {
  const char* name;
  BezierPatch x;
  BezierPatch y;
  std::vector<std::array<int, 2>> factors;  // degree and multiplicity of the squarefree factors
};

std::vector<Shape> shapes(Random& random) {
  const auto any = [&] { return random_patch(random); };
  const ControlNet c = random_net(random);
  return {
      {"x planar", planar(random), any(), {{128, 1}}},
      {"y planar", any(), planar(random), {{96, 1}, {4, 8}}},
      {"y linear in s", any(), of_degree(random, 2, 1), {{56, 1}, {4, 4}}},
      {"y linear in r", any(), of_degree(random, 1, 2), {{56, 1}, {4, 4}}},
      {"y bilinear", any(), of_degree(random, 1, 1), {{24, 1}, {4, 4}}},
      {"x linear in u", of_degree(random, 1, 2), any(), {{64, 1}}},
      {"x linear in v", of_degree(random, 2, 1), any(), {{64, 1}}},
      {"x bilinear", of_degree(random, 1, 1), any(), {{32, 1}}},
      {"both bilinear", of_degree(random, 1, 1), of_degree(random, 1, 1), {{4, 1}, {2, 3}}},
      {"no r^2 s^2", any(), without(c, {{2, 2}}), {{110, 1}, {2, 3}}},
      {"total degree 2", any(), without(c, {{2, 2}, {1, 2}, {2, 1}}), {{48, 1}, {4, 8}}},
      {"f(r) + h(s)", any(), without(c, {{2, 2}, {1, 2}, {2, 1}, {1, 1}}), {{48, 1}, {2, 16}}},
      {"r^2 in one direction", any(), fixed_direction(random, 2), {{104, 1}, {4, 2}}},
      {"y height field", any(), height_field(random), {{80, 1}, {4, 4}}},
      {"x height field", height_field(random), any(), {{80, 1}, {2, 12}}},
      {"both height fields", height_field(random), height_field(random), {{4, 1}, {2, 2}, {2, 3}}},
      {"y linear in r along one direction", any(), fixed_direction(random, 1), {{16, 1}, {16, 4}}},
      {"x and y linear, y along one direction",
       of_degree(random, 2, 1),
       fixed_direction(random, 1),
       {{8, 1}, {8, 4}}},
      {"x linear, r^2 in one direction",
       of_degree(random, 2, 1),
       fixed_direction(random, 2),
       {{48, 1}, {4, 2}}},
      {"wall and bilinear with a vertical ruling",
       vertical_wall(random),
       vertical_ruling(random, 1),
       {{2, 4}}},
      {"wall and vertical r^2", vertical_wall(random), vertical_ruling(random, 2), {{8, 1}}},
      {"wall and height field", vertical_wall(random), height_field(random), {}},
      {"mirror symmetric", mirror_symmetric(random), mirror_symmetric(random), {{4, 1}, {52, 2}}},
  };
}

}  // namespace

TEST_CASE("the exact route gives generic pairs the same eliminant", "[special_eliminant]") {
  const unsigned seed = 21;
  INFO("seed " << seed);
  Random random(seed);
  for (int repeat = 0; repeat < 2; ++repeat) {
    const BezierPatch x = random_patch(random);
    const BezierPatch y = random_patch(random);
    const auto general = turning_eliminant(x, y);
    REQUIRE(general.polynomial);
    CHECK(special_eliminant(integer_pair(x, y)).polynomial == general.polynomial);
  }
}

TEST_CASE("special shapes have eliminants of the known degrees", "[special_eliminant]") {
  const unsigned seed = 22;
  INFO("seed " << seed);
  Random random(seed);
  for (const auto& [name, x, y, factors] : shapes(random)) {
    INFO(name);
    const TurningEliminant e = turning_eliminant(x, y);
    INFO(e.degenerate);
    REQUIRE(e.polynomial);
    std::vector<std::array<int, 2>> found;
    for (const auto& [factor, multiplicity] : squarefree_factors(*e.polynomial))
      found.push_back({factor.degree(), multiplicity});
    CHECK(found == factors);
  }
}

TEST_CASE("a turning point put into a special pair is a root", "[special_eliminant]") {
  const unsigned seed = 23;
  INFO("seed " << seed);
  Random random(seed);
  const Rational u(2, 7);
  const Rational v(1, 3);
  const Rational r(3, 5);
  const Rational s(1, 4);
  for (const auto& [name, x, y, factors] : shapes(random)) {
    INFO(name);
    const std::string shape = name;
    if (shape == "both height fields" || shape == "mirror symmetric" || shape == "x planar") continue;
    Polynomial e;
    if (shape == "x height field") {  // the second patch is the free one
      const BezierPatch free =
          osculating(y.exchanged(), s, r, x(u, v), x.derivative_second(u, v)).exchanged();
      e = turning_eliminant(x, free).polynomial.value();
    } else {
      const Point tangent = y.derivative_first(r, s) - Rational(3, 2) * y.derivative_second(r, s);
      e = turning_eliminant(osculating(x, u, v, y(r, s), tangent), y).polynomial.value();
    }
    CHECK(e.sign_at(u) == 0);
    // A point of a planar patch has several parameters (r,s), all turning points of the same u.
    if (shape != "y planar") CHECK(e.derivative().sign_at(u) != 0);
  }
}

TEST_CASE("a vertical wall turns where it meets a fold of the other patch", "[special_eliminant]") {
  const unsigned seed = 26;
  INFO("seed " << seed);
  Random random(seed);
  const Rational u(2, 7);
  const Rational r(3, 5);
  const Rational s(1, 4);
  for (const std::size_t degree : {1, 2}) {
    // y_s at (r,s) becomes vertical plus 2 y_r, and the wall goes through y(r,s).
    ControlNet y = vertical_ruling(random, 2).power_basis();
    const Point vertical = {Rational(0), Rational(0), Rational(1)};
    y[0][1] = y[0][1] +
              (vertical + Rational(2) * patch(y).derivative_first(r, s) - patch(y).derivative_second(r, s));
    ControlNet x = vertical_wall(random).power_basis();
    if (degree == 1) x[2][0] = Point{};
    x[0][0] = x[0][0] + (patch(y)(r, s) - patch(x)(u, 0));
    const auto e = turning_eliminant(patch(x), patch(y)).polynomial;
    REQUIRE(e);
    CHECK(e->degree() == 4 * static_cast<int>(degree));
    CHECK(e->sign_at(u) == 0);
    CHECK(e->derivative().sign_at(u) != 0);
  }
}

TEST_CASE("the turning points of two height fields are those of their difference", "[special_eliminant]") {
  // z = u^2 + v^2 - u v and z = 1/4 + r/3 meet over f = u^2 + v^2 - u v - 1/4 - u/3 = 0; f_v = 2 v - u.
  ControlNet x;
  x[1][0] = {Rational(1), Rational(0), Rational(0)};
  x[0][1] = {Rational(0), Rational(1), Rational(0)};
  ControlNet y = x;
  x[2][0][2] = x[0][2][2] = 1;
  x[1][1][2] = -1;
  y[0][0][2] = Rational(1, 4);
  y[1][0][2] = Rational(1, 3);
  const TurningEliminant e = turning_eliminant(patch(x), patch(y));
  INFO(e.degenerate);
  REQUIRE(e.polynomial);
  // v = u/2: 3/4 u^2 - u/3 - 1/4
  CHECK(squarefree_part(*e.polynomial) == Polynomial({Rational(-3), Rational(-4), Rational(9)}));
}

TEST_CASE("a line of one patch on the other is a multiple root", "[special_eliminant]") {
  const unsigned seed = 24;
  INFO("seed " << seed);
  Random random(seed);
  for (const std::size_t degree : {1, 2}) {
    const ControlNet y = random_coefficients(random, degree, 2);
    ControlNet x = random_net(random);
    for (std::size_t j = 0; j < 3; ++j) x[0][j] = y[0][j];  // x(0,.) = y(0,.)
    const auto e = turning_eliminant(patch(x), patch(y)).polynomial;
    REQUIRE(e);
    CHECK(e->coefficient(0) == 0);
    CHECK(e->coefficient(1) == 0);
  }
}

TEST_CASE("what has no eliminant is named", "[special_eliminant]") {
  Random random(25);
  const BezierPatch any = random_patch(random);
  const auto reason = [](const BezierPatch& x, const BezierPatch& y) {
    const TurningEliminant e = turning_eliminant(x, y);
    CHECK_FALSE(e.polynomial.has_value());
    return e.degenerate;
  };
  CHECK(reason(any, any).find("R vanishes identically") == 0);
  CHECK(reason(any, any.exchanged()).find("R vanishes identically") == 0);
  CHECK(reason(planar(random), planar(random)).find("R vanishes identically") == 0);
  CHECK(reason(of_degree(random, 2, 0), any).find("x is a curve") == 0);
  CHECK(reason(any, of_degree(random, 2, 0)).find("y is a curve") == 0);
  CHECK(reason(any, of_degree(random, 0, 2)).find("y is a curve") == 0);
  CHECK(reason(any, of_degree(random, 0, 0)).find("y is a curve") == 0);
  CHECK(reason(of_degree(random, 0, 0), any).find("x is a curve") == 0);

  ControlNet uneven = random_net(random);  // straight lines x(u,.), run through by v + 3 v^2
  for (auto& row : uneven) row[2] = Rational(3) * row[1];
  CHECK(reason(patch(uneven), any).find("the lines u = const of x are straight") == 0);
}

namespace {

/// (u, v, h), h in the power basis.
BezierPatch graph_of(const std::array<std::array<Rational, 3>, 3>& h) {
  ControlNet net;
  net[1][0][0] = net[0][1][1] = 1;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) net[i][j][2] = h[i][j];
  return patch(net);
}

}  // namespace

TEST_CASE("events of curves along which patches touch", "[special_eliminant]") {
  const BezierPatch plane = graph_of({});
  // (v - u/2 - 1/3)^2: a line without events.
  const TurningEliminant line = turning_eliminant(
      graph_of({{{Rational(1, 9), Rational(-2, 3), 1}, {Rational(1, 3), -1, 0}, {Rational(1, 4), 0, 0}}}),
      plane);
  CHECK(line.touching);
  CHECK(line.polynomial.value().degree() == 0);
  // The same over (r, (3 s - s^2)/2): its two values of s meet at v = 9/8, which is over u = 19/12.
  ControlNet folded = plane.power_basis();
  folded[0][1] = {0, Rational(3, 2), 0};
  folded[0][2] = {0, Rational(-1, 2), 0};
  const TurningEliminant fold = turning_eliminant(
      graph_of({{{Rational(1, 9), Rational(-2, 3), 1}, {Rational(1, 3), -1, 0}, {Rational(1, 4), 0, 0}}}),
      patch(folded));
  CHECK(fold.touching);
  CHECK(squarefree_part(fold.polynomial.value()) == Polynomial({-19, 12}));
  // (u v - 1/3)^2: not finite at u = 0.
  const TurningEliminant hyperbola =
      turning_eliminant(graph_of({{{Rational(1, 9), 0, 0}, {0, Rational(-2, 3), 0}, {0, 0, 1}}}), plane);
  CHECK(hyperbola.touching);
  CHECK(hyperbola.polynomial.value()(0) == 0);
  CHECK(squarefree_part(*hyperbola.polynomial).degree() == 1);
  // (u - 1/3)^2 (v - 1/2): along u the line is no multiple point of a fibre, along v it meets the other one.
  const BezierPatch lines = graph_of({{{Rational(-1, 18), Rational(1, 9), 0},
                                       {Rational(1, 3), Rational(-2, 3), 0},
                                       {Rational(-1, 2), 1, 0}}});
  const TurningEliminant across = turning_eliminant(lines, plane);
  CHECK_FALSE(across.touching);
  CHECK(squarefree_part(across.polynomial.value()) == Polynomial({-1, 3}));
  const TurningEliminant along = turning_eliminant(lines.exchanged(), plane);
  CHECK(along.touching);
  CHECK(squarefree_part(along.polynomial.value()) == Polynomial({-1, 2}));
  // Multiplicities mean nothing where a line lies on the other patch, or a multiple point is not finite.
  CHECK(along.unweighted(Rational(1, 2)) == 0);
  CHECK(hyperbola.unweighted(0) == 0);
}

TEST_CASE("parallel planes and walls have no turning points", "[special_eliminant]") {
  ControlNet lower;
  lower[1][0][0] = lower[0][1][1] = 1;
  ControlNet upper = lower;
  upper[0][0][2] = 1;
  CHECK(turning_eliminant(patch(lower), patch(upper)).polynomial == Polynomial(1));
  // The walls (u^2, u, v) and (r, 2, s) share the vertical line u = 2.
  ControlNet x;
  x[2][0][0] = x[1][0][1] = x[0][1][2] = 1;
  ControlNet y;
  y[1][0][0] = y[0][1][2] = 1;
  y[0][0][1] = 2;
  const auto e = turning_eliminant(patch(x), patch(y)).polynomial;
  REQUIRE(e);
  CHECK(*e == (Polynomial::variable() - Polynomial(2)) * (Polynomial::variable() - Polynomial(2)));
}

}  // namespace exsect::special_eliminant_test
