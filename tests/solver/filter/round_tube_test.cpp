// Tubes around the curve of two cylinders whose places are known: along the narrow one about x, of radius 1,
// x = sqrt(4 - cos^2 a) at the angle a.
#include "filter/round_tube.h"

#include <algorithm>
#include <cmath>

#include "support/catch.h"

namespace exsect::round_tube_test {
namespace {

using S = ImplicitSurface;

RoundChart crossing_cylinders() {
  return RoundChart::of(S::cylinder({0, 0, 0}, {1, 0, 0}, 1), S::cylinder({0, 0, 0}, {0, 0, 1}, 2)).value();
}

/// The place of the curve at an angle of the chart.
RoundPlace on_curve(const RoundChart& chart, double angle) {
  RoundPlace place{{turned({1, 0}, angle), RoundCoordinate{0, 0}}};
  const double y = chart.position({place, {}})[1].approximation();
  place.at[1][0] = std::sqrt(4 - y * y) / chart.unit();
  return place;
}

}  // namespace

TEST_CASE("round tube: holds the curve over its length, and its neighbours not") {
  const RoundChart chart = crossing_cylinders();
  for (const double angle : {-0.9, -0.3, 0.2, 0.75}) {
    const auto tube = round_tube(chart, on_curve(chart, angle), 0, 0.05);
    REQUIRE(tube);
    for (const double s : {-0.0499, -0.03, 0.0, 0.02, 0.0499}) {
      const RoundPlace there = on_curve(chart, angle + s);
      CHECK(contains(*tube, {there, {1e-12, 1e-12}}));
      CHECK(std::fabs((offset(*tube, {there, {}}) - DoubleBall(s)).approximation()) < 1e-14);
      const NearCurve near = near_curve(*tube, s, tube->slope * s, 1e-10);
      CHECK(near.error <= 1e-10);
      CHECK(chart.difference(1, near.place, there).upper_magnitude() <= near.error + 1e-14);
    }
    for (const double s : {-0.051, 0.06, 0.4}) {
      CHECK(excludes(*tube, {on_curve(chart, angle + s), {1e-12, 1e-12}}));
      CHECK(std::isinf(near_curve(*tube, s, 0, 1e-10).error));
    }
    CHECK(excludes(*tube, {chart.moved(tube->centre, 1, 1.5 * tube->width), {1e-12, 1e-12}}));
    CHECK_FALSE(contains(*tube, {tube->centre, {0.2, 0}}));
    CHECK_FALSE(excludes(*tube, {tube->centre, {0.2, 0}}));
  }
}

TEST_CASE("round tube: none around turning points along the wrong axis, nor off the curve") {
  const RoundChart chart = crossing_cylinders();
  const RoundPlace place = on_curve(chart, 0.3);
  CHECK(round_tube(chart, place, 0, 0.1));
  CHECK_FALSE(round_tube(chart, {{place.at[0], RoundCoordinate{0, 0}}}, 0, 0.1));
  CHECK_FALSE(round_tube(chart, place, 0, 0.9));
  CHECK_FALSE(round_tube(chart, place, 0, std::nan("")));
  const auto landmarks = round_landmarks(chart).value();
  CHECK_FALSE(round_tube(chart, landmarks[0].centre, 1, 0.1));
  CHECK(round_tube(chart, landmarks[0].centre, 0, 0.1));
}

TEST_CASE("round tube: the derivatives along the arc near a place") {
  const RoundChart chart = crossing_cylinders();
  for (const double angle : {-0.6, 0.0, 0.4}) {
    const auto tube = round_tube(chart, on_curve(chart, angle), 0, 0.1).value();
    const double h = 1e-4;
    const auto at = [&](double s) {
      return chart.position({near_curve(tube, s, tube.slope * s, 1e-13).place, {}});
    };
    for (const double reach : {0.01, 0.03})
      for (const double s : {-0.06, 0.0, 0.05}) {
        const NearCurve near = near_curve(tube, s, tube.slope * s, 1e-13);
        const RoundArc arc = arc_near(tube, near, reach);
        const double before = near_curve(tube, s - h, tube.slope * (s - h), 1e-13).off,
                     after = near_curve(tube, s + h, tube.slope * (s + h), 1e-13).off;
        CHECK(std::fabs(arc.slope - (after - before) / (2 * h)) < 1e-6);
        CHECK(std::fabs(arc.bend - (after - 2 * near.off + before) / (h * h)) < 0.05);
        double most = 0, most_normal = 0, least = INFINITY;
        for (const double t : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
          const auto a = at(s + t * reach - h), b = at(s + t * reach), c = at(s + t * reach + h);
          double first = 0, second = 0, along = 0;
          for (std::size_t k = 0; k < 3; ++k) {
            const double v = (c[k].approximation() - a[k].approximation()) / (2 * h),
                         w = (a[k].approximation() - 2 * b[k].approximation() + c[k].approximation()) /
                             (h * h);
            first += v * v, second += w * w, along += v * w;
          }
          most = std::max(most, std::sqrt(second));
          most_normal = std::max(most_normal, std::sqrt(second - along * along / first));
          least = std::min(least, std::sqrt(first));
        }
        CHECK(most <= arc.acceleration * (1 + 1e-5));
        CHECK(most_normal <= arc.normal * (1 + 1e-5));
        CHECK(least >= arc.least_speed * (1 - 1e-5));
        // The enclosures are not much wider than the arc.
        CHECK(arc.acceleration < most * (1 + 12 * reach));
        CHECK(arc.normal < most_normal * (1 + 12 * reach));
        CHECK(arc.least_speed > least * (1 - 4 * reach));
      }
  }
}

}  // namespace exsect::round_tube_test
