// The eliminant of turning points against the product of J over the points themselves.
#include "lift/space_projection.h"

#include <exsect/algebra/resultant.h>
#include <exsect/geometry/implicit_surface.h>

#include "support/catch.h"

namespace exsect::space_projection_test {
namespace {

using S = ImplicitSurface;
const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                      z = SpacePolynomial::variable(2);
SpacePolynomial number(const Rational& c) { return SpacePolynomial::constant(c); }

/// u is extreme there on the curve.
bool is_turning_value(const Polynomial& norm, const Rational& u) { return norm(u) == 0; }

}  // namespace

TEST_CASE("space projection: frames are unimodular") {
  for (int attempt = 0; attempt < general_frames; ++attempt) {
    const SpaceFrame frame = general_frame(attempt);
    CHECK(determinant(frame.columns[0], frame.columns[1], frame.columns[2]) == 1);
    CHECK(dot(frame.height, frame.point(Rational(7, 3), 2, -5)) == Rational(7, 3));
  }
}

TEST_CASE("space projection: the points over one u") {
  // Where the plane x + y + z = 1 and a sphere about the origin meet u = const, by hand in the frame.
  const SpacePolynomial f = x * x + y * y + z * z - number(2), g = x + y + z - number(1);
  for (int attempt = 0; attempt < general_frames; ++attempt) {
    const SpaceFrame frame = general_frame(attempt);
    const auto projection = space_projection(f, g, frame);
    if (!projection) continue;
    CHECK(projection->shadow.degree_s() == 2);
    for (const Rational& u : {Rational(0), Rational(3, 7), Rational(-9)})
      for (const Rational& v : {Rational(1, 2), Rational(-4)}) {
        const Rational slope = projection->slope(u, v);
        REQUIRE(slope != 0);
        const Point p = frame.point(u, v, -projection->offset(u, v) / slope);
        CHECK(g(p) == 0);
        CHECK((f(p) == 0) == (projection->shadow(u, v) == 0));
        // g is linear: the shadow is f there, up to a constant factor.
        const Point q = frame.point(0, 0, -projection->offset(0, 0) / projection->slope(0, 0));
        CHECK(projection->shadow(u, v) * f(q) == projection->shadow(0, 0) * f(p));
      }
    // A circle: u has two extreme values, those of the linear form on it, rational multiples apart from the
    // radius: its centre is (1,1,1) / 3, its radius squared is 5/3.
    const Polynomial norm = turning_norm(*projection);
    REQUIRE(norm.degree() == 2);
    const Point& h = frame.height;
    const Rational mean = (h[0] + h[1] + h[2]) / 3;
    CHECK(-norm.coefficient(1) / norm.coefficient(2) / 2 == mean);
    const Rational spread = (dot(h, h) - 3 * mean * mean) * Rational(5, 3);
    CHECK(mean * mean - norm.coefficient(0) / norm.coefficient(2) == spread);
  }
}

TEST_CASE("space projection: degrees of the eliminant") {
  // Generic: m n (m + n - 2); two tori: a curve of degree 8 with 32 turning values, counted with
  // multiplicity.
  const SpacePolynomial first = x * x + Rational(2) * y * y - z * z + x * y - number(3) + z;
  const SpacePolynomial second = x * x - y * y + Rational(3) * z * z + y * z - number(1) + x;
  const auto quadrics = space_projection(first, second, general_frame(0));
  REQUIRE(quadrics);
  CHECK(turning_norm(*quadrics).degree() == 8);
  const SpacePolynomial cubic = x * x * x - y * z * z + Rational(5) * z * z * z + y * y * y - x + number(2);
  const auto both = space_projection(cubic, first, general_frame(0));
  REQUIRE(both);
  CHECK(turning_norm(*both).degree() == 18);
  CHECK(turning_norm(*both) == turning_norm(*space_projection(first, cubic, general_frame(0))));
}

TEST_CASE("space projection: a zero of J at a point is a root") {
  // The curve z = y^2, x = y^3 - y + u0 of two cubics turns where the rate of u is 0.
  const SpacePolynomial f = z - y * y + x * y - y * y * y * y + y * y, g = x - y * y * y + y;
  for (int attempt = 0; attempt < 3; ++attempt) {
    const SpaceFrame frame = general_frame(attempt);
    const auto projection = space_projection(f, g, frame);
    if (!projection) continue;
    const SpacePolynomial turning = turning_form(f, g, frame.height);
    const Polynomial norm = turning_norm(*projection);
    for (const Rational& t : {Rational(0), Rational(1), Rational(2, 3)}) {
      const Point p = {t * t * t - t, t, t * t};
      REQUIRE(f(p) == 0);
      REQUIRE(g(p) == 0);
      CHECK(is_turning_value(norm, dot(frame.height, p)) == (turning(p) == 0));
    }
  }
}

TEST_CASE("space projection: common leading forms are lowered") {
  SpacePolynomial f = S::torus({0, 0, 0}, {1, 1, 1}, 3, 1).equation();
  SpacePolynomial g = S::torus({1, 0, 0}, {1, 2, 1}, 2, 1).equation();
  lower_degrees(f, g);
  CHECK(f.degree() == 4);
  CHECK(g.degree() == 3);
  SpacePolynomial h = Rational(7, 2) * f;
  lower_degrees(f, h);
  CHECK(h.is_zero());
  SpacePolynomial outer = S::sphere({0, 0, 0}, 3).equation(), inner = S::sphere({0, 0, 0}, 2).equation();
  lower_degrees(outer, inner);
  CHECK(inner.degree() == 0);
}

TEST_CASE("space projection: products over the points over u") {
  // The line x = 1 + t, y = 2 t, z = 1 - t, as that of two planes, and a linear form at its point over u.
  const SpacePolynomial f = Rational(2) * x - y - number(2), g = x + z - number(2);
  const SpacePolynomial form = x * x - z * y + number(3);
  for (int attempt = 0; attempt < general_frames; ++attempt) {
    const SpaceFrame frame = general_frame(attempt);
    const auto projection = space_projection(f, g, frame);
    if (!projection) continue;
    const auto norm = norm_over(*projection, projection->shadow, form);
    REQUIRE(norm);
    const auto at = [&](const Rational& t) { return Point{1 + t, 2 * t, 1 - t}; };
    const Rational unit = (*norm)(dot(frame.height, at(0))) / form(at(0));
    for (const Rational& t : {Rational(1, 3), Rational(-7), Rational(22, 5)})
      CHECK((*norm)(dot(frame.height, at(t))) == unit * form(at(t)));
    CHECK(norm_over(*projection, projection->shadow, f)->is_zero());
  }
  // The whole curve of two quadrics: by the other formula, up to a constant factor.
  const SpacePolynomial tube = x * x + y * y - number(1), ball = x * x + y * y + z * z - x - number(2);
  const auto projection = space_projection(tube, ball, general_frame(0));
  REQUIRE(projection);
  const Polynomial norm = turning_norm(*projection);
  const auto product =
      norm_over(*projection, projection->shadow, turning_form(tube, ball, general_frame(0).height));
  REQUIRE(product);
  CHECK(product->primitive() == norm.primitive());
}

TEST_CASE("space projection: forms through a circle and through a quartic curve") {
  // As many as Hilbert's function leaves: 2 e + 1 and 4 e conditions on degree e.
  const SpacePolynomial ball = x * x + y * y + z * z - number(25), plane = z - number(3);
  const SpacePolynomial saddle = x * y - number(2) * z;
  const auto circle = space_projection(ball, plane, general_frame(0)),
             quartic = space_projection(ball, saddle, general_frame(0));
  REQUIRE((circle && quartic));
  CHECK(forms_through(*circle, circle->shadow, 1) == std::vector{plane});
  CHECK(forms_through(*circle, circle->shadow, 2).size() == 5);
  CHECK(forms_through(*circle, circle->shadow, 3).size() == 13);
  for (const SpacePolynomial& form : forms_through(*circle, circle->shadow, 3))
    for (const Point& p : {Point{4, 0, 3}, Point{0, -4, 3}, Point{Rational(16, 5), Rational(-12, 5), 3}})
      CHECK(form(p) == 0);
  CHECK(forms_through(*quartic, quartic->shadow, 1).empty());
  CHECK(forms_through(*quartic, quartic->shadow, 3).size() == 8);
  const std::vector<SpacePolynomial> pencil = forms_through(*quartic, quartic->shadow, 2);
  CHECK(pencil.size() == 2);
  for (const SpacePolynomial& form : pencil)
    CHECK(form == form.coefficient({2, 0, 0}) * ball + form.coefficient({1, 1, 0}) * saddle);
}

}  // namespace exsect::space_projection_test
