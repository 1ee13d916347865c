#include "lift/lifted_course.h"

#include <exsect/algebra/nearest_rounding.h>

#include <chrono>
#include <cmath>
#include <cstdio>

#include "lift/pair_region.h"
#include "support/catch.h"

namespace exsect::lifted_course_test {
namespace {

using S = ImplicitSurface;
const Point origin = {0, 0, 0}, up = {0, 0, 1};

/// All vertices are about on both surfaces, as bounded; the sum of the lengths.
double drawn_length(const S& surface, const S& other, double tolerance) {
  return in_nearest_rounding([&] {
    const LiftedCurve curve = lifted_curve(surface, other, pair_region(surface, other).all).value();
    double length = 0;
    std::size_t points = 0;
    for (std::size_t i = 0; i < curve.arcs.size(); ++i) {
      const SpaceCourse course = course_in_space(curve, i, tolerance);
      CHECK(course.error_bound <= tolerance);
      points += course.points.size();
      for (std::size_t k = 0; k + 1 < course.points.size(); ++k) {
        const auto &a = course.points[k], &b = course.points[k + 1];
        length += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        for (const S* of : {&surface, &other}) {
          const Point p = {from_double(a[0]), from_double(a[1]), from_double(a[2])};
          CHECK(std::fabs(to_double(of->equation()(p))) < 1e-10);
        }
      }
    }
    WARN(points);
    return length;
  });
}

}  // namespace

TEST_CASE("drawn lengths of circles and of Viviani's curve") {
  const double pi = std::acos(-1);
  CHECK(std::fabs(drawn_length(S::cylinder(origin, up, 1), S::sphere(origin, 1), 1e-6) - 2 * pi) < 1e-4);
  CHECK(std::fabs(drawn_length(S::plane(origin, up), S::torus(origin, up, 2, 1), 1e-6) - 8 * pi) < 1e-4);
  // 4 sqrt(2) E(1/2) times 2 for radius 2
  CHECK(std::fabs(drawn_length(S::cylinder({1, 0, 0}, up, 1), S::sphere(origin, 2), 1e-6) -
                  8 * std::sqrt(2) * 1.3506438810476755) < 1e-4);
}

}  // namespace exsect::lifted_course_test
