#include "lift/lifted_course.h"

#include <exsect/algebra/nearest_rounding.h>

#include <cmath>
#include <utility>

#include "lift/pair_region.h"
#include "lift/ring_curve.h"
#include "support/catch.h"

namespace exsect::lifted_course_test {
namespace {

using S = ImplicitSurface;
const Point origin = {0, 0, 0}, up = {0, 0, 1};

/// All vertices are about on both surfaces, as bounded, and much nearer than the tolerance; the sum of the
/// lengths.
double drawn_length(const S& surface, const S& other, double tolerance) {
  return in_nearest_rounding([&] {
    const LiftedCurve curve = lifted_curve(surface, other, pair_region(surface, other).all).value();
    double length = 0;
    for (std::size_t i = 0; i < curve.arcs.size(); ++i) {
      const SpaceCourse course = course_in_space(curve, i, tolerance);
      CHECK(course.error_bound <= tolerance);
      for (std::size_t k = 0; k + 1 < course.points.size(); ++k) {
        const auto &a = course.points[k], &b = course.points[k + 1];
        length += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        for (const S* of : {&surface, &other}) {
          const Point p = {from_double(a[0]), from_double(a[1]), from_double(a[2])};
          CHECK(std::fabs(to_double(of->equation()(p))) < 1e-10 + 1e-2 * tolerance);
        }
      }
    }
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

// A chord of length L has the bound κ L² / 4 in an arc of curvature κ, as the slope to it is κ L / 2 at most.
// So the least number for the tolerance t is the integral of sqrt(κ / (4 t)) over the length.
TEST_CASE("chords are hardly more than the tolerance asks for") {
  in_nearest_rounding([] {
    const S tube = S::cylinder({Rational(1, 8), 0, 0}, {1, -1, 1}, Rational(2, 3)),
            ball = S::sphere(origin, 1);
    const LiftedCurve curve = lifted_curve(tube, ball, pair_region(tube, ball).all).value();
    REQUIRE(!curve.arcs.empty());
    const double tolerance = 1e-7;
    double least = 0, drawn = 0;
    for (std::size_t i = 0; i < curve.arcs.size(); ++i) {
      drawn += static_cast<double>(course_in_space(curve, i, tolerance).points.size() - 1);
      const SpaceCourse fine = course_in_space(curve, i, tolerance / 100);
      std::array<double, 3> before{};
      for (std::size_t k = 1; k < fine.points.size(); ++k) {
        std::array<double, 3> chord{};
        for (std::size_t c = 0; c < 3; ++c) chord[c] = fine.points[k][c] - fine.points[k - 1][c];
        const double length = std::hypot(chord[0], chord[1], chord[2]);
        const std::array<double, 3> cross = {chord[1] * before[2] - chord[2] * before[1],
                                             chord[2] * before[0] - chord[0] * before[2],
                                             chord[0] * before[1] - chord[1] * before[0]};
        if (k > 1) {
          const double turn = std::hypot(cross[0], cross[1], cross[2]) /
                              (length * std::hypot(before[0], before[1], before[2]));
          least += std::sqrt(turn * length / (4 * tolerance));
        }
        before = chord;
      }
    }
    INFO(drawn << " chords, " << least << " at least");
    CHECK(drawn < 1.3 * least);
    CHECK(drawn > 0.8 * least);
    return 0;
  });
}

// On this torus the curve keeps y^2 small beside its silhouette, where rectangles alone do not tell y.
TEST_CASE("an arc that nearly touches the silhouette has few chords") {
  in_nearest_rounding([] {
    const S ring = S::torus({Rational(3, 8), Rational(-1, 16), Rational(7, 16)}, {4, -1, -4},
                            Rational(17, 16), Rational(1, 2)),
            cone = S::cone({Rational(5, 16), Rational(35, 16), Rational(-1, 2)}, {0, -1, 0}, Rational(1, 2));
    const RingCurve curve = ring_curve(ring, cone, pair_region(ring, cone).all).value();
    std::size_t points = 0;
    for (const RingArc& arc : curve.arcs)
      points += course_in_space(curve.halves[arc.half], arc.below, 4e-6).points.size();
    CHECK(points > 2000);
    CHECK(points < 12000);  // 70 000 from rectangles
    return 0;
  });
}

TEST_CASE("finer than doubles lead, an arc is drawn exactly: the same lengths") {
  // Curves without symmetry, and one that crosses the plane of symmetry in irrational
  // points.
  const S cone = S::cone({0, 0, -1}, {1, 2, 8}, Rational(1, 2)), ball = S::sphere({Rational(1, 3), 0, 0}, 1);
  const S tube = S::cylinder({Rational(1, 8), 0, 0}, {1, -1, 1}, Rational(2, 3));
  for (const auto& [a, b] : {std::pair{cone, ball}, std::pair{tube, cone}, std::pair{tube, ball}}) {
    const double quick = drawn_length(a, b, 1e-4), exact = drawn_length(a, b, 1e-9);
    CHECK(quick == Approx(exact).epsilon(1e-3));
    CHECK(quick <= exact + 1e-9);
  }
}

TEST_CASE("courses of arcs far from the origin and of other sizes") {
  const double pi = std::acos(-1);
  const Point far = {100000000, -100000000, 3};
  CHECK(drawn_length(S::plane(origin, up), S::torus(origin, up, 2, 1), 1e-3) == Approx(8 * pi).epsilon(1e-3));
  CHECK(in_nearest_rounding([&] {
          const S a = S::cylinder(far, {1, 2, 2}, Rational(254, 10)), b = S::sphere(far, Rational(254, 10));
          const LiftedCurve curve = lifted_curve(a, b, pair_region(a, b).all).value();
          double length = 0;
          for (std::size_t i = 0; i < curve.arcs.size(); ++i) {
            const SpaceCourse course = course_in_space(curve, i, 1e-4);
            CHECK(course.error_bound <= 1e-4);
            for (std::size_t k = 0; k + 1 < course.points.size(); ++k)
              length += std::hypot(course.points[k + 1][0] - course.points[k][0],
                                   course.points[k + 1][1] - course.points[k][1],
                                   course.points[k + 1][2] - course.points[k][2]);
          }
          return length;
        }) == Approx(2 * pi * 25.4).epsilon(1e-3));
}

}  // namespace exsect::lifted_course_test
