// Ellipses against the equations of both surfaces, and against the curves that the shadow gives.
#include "lift/ellipse_section.h"

#include <exsect/geometry/surface_box.h>
#include <exsect/solver/intersect_equations.h>

#include <cmath>
#include <random>

#include "support/catch.h"

namespace exsect::ellipse_section_test {
namespace {

using S = ImplicitSurface;
const Point origin = {0, 0, 0}, up = {0, 0, 1}, right = {1, 0, 0}, oblique = {1, 2, -2};

/// On the ellipse's plane the equation is its value in the centre times 1 - x^2 / a - y^2 / b.
void check_equation(const EllipseSection& ellipse, const S& surface) {
  const Rational inside = surface.equation()(ellipse.centre);
  for (const auto& [x, y] :
       {std::pair<Rational, Rational>{1, 0}, {0, 1}, {-2, 3}, {Rational(1, 7), 5}, {4, Rational(-2, 3)}}) {
    const Rational share = 1 - x * x / ellipse.along_reach - y * y / ellipse.across_reach;
    CHECK(surface.equation()(ellipse.centre + x * ellipse.along + y * ellipse.across) == inside * share);
  }
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], std::hypot(a[1] - b[1], a[2] - b[2]));
}

double distance_to_chord(const std::array<double, 3>& p, const std::array<double, 3>& a,
                         const std::array<double, 3>& b) {
  double along = 0, squared = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    along += (p[k] - a[k]) * (b[k] - a[k]);
    squared += (b[k] - a[k]) * (b[k] - a[k]);
  }
  const double t = std::clamp(along / squared, 0.0, 1.0);
  return distance(p, {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
}

/// At the angle, about: from (-1,0) over (0,1).
std::array<double, 3> point_at(const EllipseSection& ellipse, double angle) {
  const double x = -std::cos(angle) * std::sqrt(to_double(ellipse.along_reach));
  const double y = std::sin(angle) * std::sqrt(to_double(ellipse.across_reach));
  std::array<double, 3> p{};
  for (std::size_t k = 0; k < 3; ++k)
    p[k] = to_double(ellipse.centre[k]) + x * to_double(ellipse.along[k]) + y * to_double(ellipse.across[k]);
  return p;
}

/// The largest distance of points of the ellipse from the polyline of their half.
double largest_distance(const EllipseSection& ellipse, const SurfaceIntersection& result) {
  double largest = 0;
  for (const SpaceArc& arc : result.arcs) {
    const double side = arc.id == 0 ? 1 : -1;
    for (int i = 0; i <= 997; ++i) {
      const std::array<double, 3> p = point_at(ellipse, side * std::acos(-1.0) * i / 997);
      double least = INFINITY;
      for (std::size_t k = 0; k + 1 < arc.polyline.size(); ++k)
        least = std::min(least, distance_to_chord(p, arc.polyline[k], arc.polyline[k + 1]));
      largest = std::max(largest, least);
    }
  }
  return largest;
}

std::function<double(double)> relative(double tolerance) {
  return [tolerance](double extent) { return tolerance * extent; };
}

}  // namespace

TEST_CASE("ellipse section: places that are known") {
  const auto circle = ellipse_section(S::plane({0, 0, 3}, {0, 0, 7}), S::sphere(origin, 5)).value();
  CHECK(circle.centre == Point{0, 0, 3});
  CHECK(circle.along_reach * dot(circle.along, circle.along) == 16);
  CHECK(circle.across_reach * dot(circle.across, circle.across) == 16);
  // y = 3z/4 on the cylinder of radius 2 about z: semi-axes 2 and 2 * 5/3.
  const auto oval = ellipse_section(S::cylinder({0, 0, 5}, up, 2), S::plane(origin, {0, 4, -3})).value();
  CHECK(oval.centre == origin);
  CHECK(is_zero(cross(oval.across, right)));
  CHECK(oval.across_reach * dot(oval.across, oval.across) == 4);
  CHECK(oval.along_reach * dot(oval.along, oval.along) == Rational(100, 9));
  const auto lens = ellipse_section(S::sphere(origin, 5), S::sphere({6, 0, 0}, 5)).value();
  CHECK(lens.centre == Point{3, 0, 0});
  CHECK(lens.along_reach * dot(lens.along, lens.along) == 16);
}

TEST_CASE("ellipse section: nothing but ellipses") {
  const S ball = S::sphere(origin, 1), tube = S::cylinder(origin, up, 1), cone = S::cone(origin, up, 1, 2);
  const Rational little = power_of_two(-60);
  CHECK_FALSE(ellipse_section(ball, S::plane({0, 0, 1}, up)));
  CHECK_FALSE(ellipse_section(ball, S::plane({0, 0, 1 + little}, up)));
  CHECK(ellipse_section(ball, S::plane({0, 0, 1 - little}, up)));
  CHECK_FALSE(ellipse_section(ball, S::sphere({2, 0, 0}, 1)));
  CHECK(ellipse_section(ball, S::sphere({2 - little, 0, 0}, 1)));
  CHECK_FALSE(ellipse_section(ball, S::sphere(origin, 2)));
  CHECK_FALSE(ellipse_section(ball, ball));
  CHECK_FALSE(ellipse_section(tube, S::plane(origin, right)));
  CHECK(ellipse_section(tube, S::plane(origin, {1, 0, little})));
  CHECK_FALSE(ellipse_section(cone, S::plane({0, 0, 1}, {1, 0, 1})));  // a parabola
  CHECK(ellipse_section(cone, S::plane({0, 0, 1}, {1, 0, 1 + little})));
  CHECK_FALSE(ellipse_section(cone, S::plane({0, 0, 1}, {1, 0, 1 - little})));  // a hyperbola
  CHECK_FALSE(ellipse_section(cone, S::plane(origin, up)));
  CHECK_FALSE(ellipse_section(tube, S::cylinder(origin, right, 1)));
  CHECK_FALSE(ellipse_section(S::torus(origin, up, 2, 1), S::plane(origin, up)));
  CHECK_FALSE(ellipse_section(S::polynomial(ball.equation()), S::plane(origin, up)));
}

TEST_CASE("ellipse section: random ones by both equations") {
  const unsigned seed = 1826;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  const auto number = [&] { return Rational(std::uniform_int_distribution<int>(-40, 40)(random), 8); };
  const auto vector = [&] {
    Point p = {number(), number(), number()};
    return is_zero(p) ? oblique : p;
  };
  int found = 0;
  for (int round = 0; round < 200; ++round) {
    const Point at = vector(), axis = vector();
    const Rational size = abs(number()) + 1;
    const S plane = S::plane(vector(), vector());
    for (const S& other : {S::sphere(at, Length::of_squared(size)), S::cylinder(at, axis, size),
                           S::cone(at, axis, Length::of_squared(size / 2), 2)}) {
      const auto ellipse = ellipse_section(other, plane);
      if (!ellipse) continue;
      ++found;
      check_equation(*ellipse, other);
      CHECK(plane.equation()(ellipse->centre) == 0);
      CHECK(dot(plane.data()->axis, ellipse->along) == 0);
      CHECK(dot(plane.data()->axis, ellipse->across) == 0);
      CHECK(dot(ellipse->along, ellipse->across) == 0);
      CHECK(ellipse->along_reach > 0);
      CHECK(ellipse->across_reach > 0);
    }
    const S ball = S::sphere(at, size), beside = S::sphere(at + vector(), Length::of_squared(size));
    if (const auto ellipse = ellipse_section(ball, beside)) {
      ++found;
      check_equation(*ellipse, ball);
      check_equation(*ellipse, beside);
    }
  }
  CHECK(found > 150);
}

TEST_CASE("ellipse section: polylines keep their bounds, of all shapes and sizes") {
  for (const EllipseSection& ellipse :
       {EllipseSection{origin, right, up, 1, 1}, EllipseSection{origin, right, up, 1, Rational(1, 1000000)},
        EllipseSection{{1, 2, 3}, {2, -2, 1}, {1, 2, 2}, Rational(2, 7), Rational(645, 7)},
        EllipseSection{{100000000, -3, 5}, {2, -2, 1}, {1, 2, 2}, Rational(254, 10), 3},
        EllipseSection{origin, right, up, power_of_two(-400), power_of_two(-402)}})
    for (const double tolerance : {0.3, 1e-2, 1e-4, 1e-6}) {
      INFO(tolerance);
      const SurfaceIntersection result = drawn(ellipse, relative(tolerance));
      const double size = std::sqrt(
          to_double(std::max<Rational>(ellipse.along_reach * dot(ellipse.along, ellipse.along),
                                       ellipse.across_reach * dot(ellipse.across, ellipse.across))));
      const double far = std::fabs(to_double(ellipse.centre[0])) * 0x1p-48;
      CHECK(result.arcs[0].error_bound <= 2 * size * tolerance + far);
      REQUIRE(result.arcs.size() == 2);
      CHECK(result.arcs[0].error_bound == result.arcs[1].error_bound);
      CHECK(static_cast<double>(result.arcs[0].polyline.size()) < 4 / std::sqrt(tolerance) + 20);
      CHECK(largest_distance(ellipse, result) <= result.arcs[0].error_bound + 2 * far + size * 0x1p-48);
      for (std::size_t i = 0; i < 2; ++i) {
        const SpaceNode& node = result.nodes[i];
        for (std::size_t k = 0; k < 3; ++k) CHECK(to_double(node.box[k].width()) <= size * 0x1p-100);
        const double t = std::sqrt(to_double(ellipse.along_reach)) * (i == 0 ? -1 : 1);
        for (std::size_t k = 0; k < 3; ++k)
          CHECK(std::fabs(node.approx[k] - (to_double(ellipse.centre[k]) +
                                            t * to_double(ellipse.along[k]))) <= 2 * far + size * 0x1p-48);
        for (const SpaceArc& arc : result.arcs)
          CHECK((i == 0 ? arc.polyline.front() : arc.polyline.back()) == node.approx);
      }
    }
}

TEST_CASE("ellipse section: the whole answer is that of the shadow") {
  IntersectOptions coarse;
  coarse.tolerance = 1e-4;
  const S ball = S::sphere({1, 0, 2}, 3), tube = S::cylinder({1, 0, 0}, oblique, 2),
          cone = S::cone({0, 1, 0}, {1, 0, 2}, Rational(1, 2)), wall = S::plane({1, 1, 1}, {2, 1, 3});
  for (const auto& [first, second] : {std::pair(ball, wall), std::pair(tube, wall), std::pair(cone, wall),
                                      std::pair(ball, S::sphere({2, 1, 0}, 2))}) {
    const SurfaceIntersection found = intersect(first, second, coarse);
    const SurfaceIntersection shadow =
        intersect(first.bound() ? S::cone({0, 1, 0}, {1, 0, 2}, Rational(1, 2), 2) : first,
                  S::polynomial(second.equation()), coarse);
    REQUIRE(found.curves.size() == 1);
    REQUIRE(shadow.curves.size() == 1);
    CHECK(found.curves[0].kind == shadow.curves[0].kind);
    CHECK(*found.curves[0].point == *shadow.curves[0].point);
    CHECK(found.curves[0].radius_squared == shadow.curves[0].radius_squared);
    CHECK(is_zero(cross(*found.curves[0].direction, *shadow.curves[0].direction)));
    CHECK(found.curves[0].is_closed);
  }
  // Of one nappe all of the ellipse or nothing.
  CHECK(intersect(S::cone(origin, up, 1), S::plane({0, 0, 2}, {1, 0, 3}), coarse).curves.size() == 1);
  CHECK(intersect(S::cone(origin, up, 1), S::plane({0, 0, -2}, {1, 0, 3}), coarse).curves.empty());
  // In a box it is cut.
  const S half = boxed(ball, {.axis = up, .sector = AxisSector{{1, 0, 0}, {0, 1, 0}}});
  CHECK_FALSE(intersect(half, wall, coarse).curves.at(0).is_closed);
}

}  // namespace exsect::ellipse_section_test
