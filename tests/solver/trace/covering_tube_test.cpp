#include "trace/covering_tube.h"

#include <cmath>
#include <limits>
#include <random>

#include "support/known_curves.h"
#include "trace/tube_points.h"

namespace exsect::covering_tube_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

constexpr double kAnywhere = std::numeric_limits<double>::infinity();

SearchRegion box_around(const std::array<double, 4>& middle, double half) {
  SearchRegion box{};
  for (std::size_t j = 0; j < 4; ++j) {
    box.lower[j] = middle[j] - half;
    box.upper[j] = middle[j] + half;
  }
  return box;
}

}  // namespace

TEST_CASE("covering tube: holds all of the hyperbola in the box", "[tube]") {
  const unsigned seed = 6;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(0.3, 0.9), off(-1, 1);
  const auto system = system_of<DoubleBall>(kHyperbola);
  int found = 0;
  for (int round = 0; round < 300; ++round) {
    const double half = std::exp2(-7 + 3 * off(generator)), u = place(generator), v = 1 / (4 * u);
    // The hyperbola passes through the box, or by it.
    const std::array<double, 4> middle = {u + half * off(generator), v + 2 * half * off(generator), u, v};
    const SearchRegion box = box_around(middle, half);
    const auto tube = covering_tube(system, box, std::nullopt, kAnywhere);
    if (!tube) continue;
    ++found;
    CHECK(contains(*tube, ball_box<DoubleBall>(box)));
    for (std::size_t corner = 0; corner < 16; ++corner) {
      BallPoint<DoubleBall> at;
      for (std::size_t j = 0; j < 4; ++j) at[j] = (corner >> j & 1U) != 0 ? box.upper[j] : box.lower[j];
      CHECK(contains(*tube, at));
    }
    for (int i = 0; i < 20; ++i) {
      const double s = middle[0] + half * off(generator), t = 1 / (4 * s);
      const BallPoint<DoubleBall> on = {s, t, s, t};
      bool is_inside = true;
      for (std::size_t j = 0; j < 4; ++j)
        is_inside = is_inside && box.lower[j] <= on[j].midpoint().approximation() &&
                    on[j].midpoint().approximation() <= box.upper[j];
      if (is_inside) CHECK_FALSE(excludes(*tube, on));
    }
    // One of the three points is enough.
    int asked = 0;
    CHECK(is_arc_known(*tube, [&](const auto&) { return ++asked == 3; }));
    CHECK_FALSE(is_arc_known(*tube, [](const auto&) { return false; }));
  }
  CHECK(found > 200);
}

TEST_CASE("covering tube: along the axis that is wanted, and not for a curve far away", "[tube]") {
  const auto system = system_of<DoubleBall>(kHyperbola);
  const SearchRegion near = box_around({0.5, 0.5, 0.5, 0.5}, 0x1p-8);
  for (const std::size_t axis : {0U, 1U, 2U, 3U}) {
    const auto tube = covering_tube(system, near, axis, 2);
    REQUIRE(tube);
    CHECK(tube->axis == axis);
  }
  const SearchRegion apart = box_around({0.5, 0.53, 0.5, 0.53}, 0x1p-8);
  CHECK(covering_tube(system, apart, std::nullopt, kAnywhere));
  CHECK_FALSE(covering_tube(system, apart, std::nullopt, 2));
}

TEST_CASE("covering tube: a box is enclosed by its balls, also where its middle is no double", "[tube]") {
  const unsigned seed = 7;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int round = 0; round < 1000; ++round) {
    SearchRegion box{};
    for (std::size_t j = 0; j < 4; ++j) {
      box.lower[j] = any(generator);
      box.upper[j] =
          round % 2 == 0 ? std::nextafter(box.lower[j], 2) : box.lower[j] + std::exp2(20 * any(generator));
    }
    const auto check = [&](const auto& balls) {
      for (std::size_t j = 0; j < 4; ++j) {
        CHECK(encloses(balls[j], from_double(box.lower[j])));
        CHECK(encloses(balls[j], from_double(box.upper[j])));
      }
    };
    check(ball_box<DoubleBall>(box));
    check(ball_box<DoubleDoubleBall>(box));
    check(ball_box<ArbBall<256>>(box));
  }
}

}  // namespace exsect::covering_tube_test
