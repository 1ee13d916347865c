// Stars of curves whose singular points are known.
#include "lift/crossing_star.h"

#include "support/catch.h"

namespace exsect::crossing_star_test {
namespace {

const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                      z = SpacePolynomial::variable(2);
SpacePolynomial number(const Rational& c) { return SpacePolynomial::constant(c); }

/// Left and right arcs of the only centre over the u of a point, which is the centre; -1: no such centre.
struct Shape {
  int left = -1, right = -1;
  bool is_singular = false;
};

int arcs_over(const SpaceProjection& projection, const CrossingStar& star, const Rational& u) {
  return static_cast<int>(real_roots(projection.shadow.at_r(u), star.strip.lower, star.strip.upper).size());
}

Shape shape_at(const SpacePolynomial& f, const SpacePolynomial& g, const Point& p) {
  for (int attempt = 0; attempt < general_frames; ++attempt) {
    const auto projection = space_projection(f, g, general_frame(attempt));
    if (!projection) continue;
    const Rational u = dot(projection->frame.height, p);
    const auto centres = centres_over(*projection, u);
    if (!centres || centres->size() != 1) continue;
    const Rational size(1, 1000);
    const CrossingStar star = crossing_star(*projection, centres->front(), {u - size, u + size}, size);
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(star.box[k].lower <= p[k]);
      CHECK(p[k] <= star.box[k].upper);
      CHECK(star.box[k].width() <= size);
    }
    CHECK((star.window.lower < u && u < star.window.upper));
    return {arcs_over(*projection, star, star.window.lower), arcs_over(*projection, star, star.window.upper),
            centres->front().is_singular};
  }
  return {};
}

}  // namespace

TEST_CASE("crossing star: crossings, touch points, cusps") {
  const SpacePolynomial tube = x * x + y * y - number(1), across = z * z + y * y - number(1);
  const Shape crossing = shape_at(tube, across, {0, 1, 0});
  CHECK(crossing.left == 2);
  CHECK(crossing.right == 2);
  CHECK(crossing.is_singular);
  const SpacePolynomial beside = z * z + (y - number(2)) * (y - number(2)) - number(1);
  const Shape touch = shape_at(tube, beside, {0, 1, 0});
  CHECK(touch.left == 0);
  CHECK(touch.right == 0);
  CHECK(touch.is_singular);
  const Shape cusp = shape_at(y * y - x * x * x, z - x * x, {0, 0, 0});
  CHECK(cusp.left + cusp.right == 2);
  CHECK(cusp.is_singular);
  const Shape apex = shape_at(x * x + y * y - z * z, z - Rational(1, 2) * x, {0, 0, 0});
  CHECK(apex.left + apex.right == 0);
  CHECK(apex.is_singular);
}

TEST_CASE("crossing star: a point in which both surfaces are singular, and a curve along y") {
  const SpaceFrame frame = general_frame(0);
  const auto form = [](const Point& p) { return p[0] * x + p[1] * y + p[2] * z; };
  const SpacePolynomial square = x * x + y * y + z * z;
  const auto centres = [&](const SpacePolynomial& f, const SpacePolynomial& g) {
    auto projection = space_projection(f, g, frame);
    REQUIRE(projection);
    CHECK(!centres_over(*projection, RealAlgebraic(0)));
    projection->quadratic = space_quadratic(f, g, frame);
    return centres_over(*projection, RealAlgebraic(0));
  };
  const auto apex = centres(square - number(2) * z * z, square - number(3) * x * x);
  REQUIRE(apex);
  REQUIRE(apex->size() == 1);
  CHECK(apex->front().is_singular);
  // Spheres through the origin, whose circle runs along y there.
  const Point a = cross(frame.columns[2], Point{1, 0, 0}), b = cross(frame.columns[2], a);
  CHECK(!centres(square - form(a), square - form(b)));
}

TEST_CASE("crossing star: a regular point where u turns, and rectangles without zeros") {
  const auto projection = space_projection(x * x + y * y + z * z - number(2), x + y, general_frame(0));
  REQUIRE(projection);
  const Polynomial norm = turning_norm(*projection);
  for (const RealAlgebraic& u : real_roots(norm, -100, 100)) {
    const auto centres = centres_over(*projection, u);
    REQUIRE(centres);
    REQUIRE(centres->size() == 1);
    CHECK(!centres->front().is_singular);
    const RationalInterval at = u.refined_to(Rational(1, 1000)).interval();
    const CrossingStar star =
        crossing_star(*projection, centres->front(), {at.lower - Rational(1, 10), at.upper + Rational(1, 10)},
                      Rational(1, 8));
    const int left = arcs_over(*projection, star, star.window.lower);
    CHECK(left + arcs_over(*projection, star, star.window.upper) == 2);
    CHECK(left != 1);
  }
  CHECK(has_no_zero_on(BivariatePolynomial::r() - BivariatePolynomial::s(), {2, 3}, {0, 1}));
  CHECK(!has_no_zero_on(BivariatePolynomial::r() - BivariatePolynomial::s(), {1, 3}, {0, 2}));
}

}  // namespace exsect::crossing_star_test
