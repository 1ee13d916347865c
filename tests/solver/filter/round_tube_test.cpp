// Tubes around the curve of two cylinders whose places are known: along the narrow one about x, of radius 1,
// x = sqrt(4 - cos^2 a) at the angle a.
#include "filter/round_tube.h"

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

TEST_CASE("round tube: the second derivative along the arc") {
  const RoundChart chart = crossing_cylinders();
  const auto tube = round_tube(chart, on_curve(chart, 0.4), 0, 0.05).value();
  const double h = 1e-4;
  const auto at = [&](double s) {
    return chart.position({near_curve(tube, s, tube.slope * s, 1e-13).place, {}});
  };
  for (const double s : {-0.04, 0.0, 0.03}) {
    const auto a = at(s - h), b = at(s), c = at(s + h);
    double squared = 0;
    for (std::size_t k = 0; k < 3; ++k)
      squared +=
          std::pow((a[k].approximation() - 2 * b[k].approximation() + c[k].approximation()) / (h * h), 2);
    CHECK(std::sqrt(squared) <= tube.acceleration * (1 + 1e-3));
    CHECK(std::sqrt(squared) >= tube.acceleration / 4);
  }
}

}  // namespace exsect::round_tube_test
