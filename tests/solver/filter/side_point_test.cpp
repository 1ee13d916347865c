#include "filter/side_point.h"

#include "segment.h"
#include "support/power_nets.h"

namespace exsect::side_point_test {
namespace {

using filter::Bicubic;
using filter::Vec4;
using testing::plane_patch;
using testing::Segment;

/// The corner of (u, v, 0) and (a s^2, s, r), where all are 0; r = 0 all along the curve.
std::optional<filter::SidePointOf<Bicubic>> corner_along_a_side(const Rational& a) {
  ControlNet c{};
  c[0][2] = {a, 0, 0};
  c[0][1] = {0, 1, 0};
  c[1][0] = {0, 0, 1};
  const auto x = filter::elevated<Bicubic>(plane_patch());
  const auto y = filter::elevated<Bicubic>(BezierPatch::from_power_basis(c));
  const auto pair = filter::make_pair_of<Bicubic>(x, y).value();
  return filter::side_point_near<Bicubic>(x, y, pair, {-0.5, -0.5, -0.5, -0.5});
}

/// The corner of (u, v, 0) and (r, a r^2 s, s - r^3): v = a u^5, s = u^3.
std::optional<filter::SidePointOf<Bicubic>> corner_of_order_five(const Rational& a) {
  using testing::Terms;
  const auto x = filter::elevated<Bicubic>(plane_patch());
  const auto y = filter::elevated<Bicubic>(
      testing::power_patch({Terms{{{1, 0}, 1}}, Terms{{{2, 1}, a}}, Terms{{{0, 1}, 1}, {{3, 0}, -1}}}, 3));
  const auto pair = filter::make_pair_of<Bicubic>(x, y).value();
  return filter::side_point_near<Bicubic>(x, y, pair, {-0.5, -0.5, -0.5, -0.5});
}

}  // namespace

TEST_CASE("side point: the end of a segment on sides of both patches", "[filter]") {
  const Segment segment;
  const auto point =
      filter::side_point_near<Bicubic>(segment.x, segment.y, segment.pair, testing::kNearTheEnd);
  REQUIRE(point);
  CHECK(point->on == Vec4{0.5, 0, 0.5, 0});
  CHECK(point->enters);
  CHECK((point->leaving == 0 || point->leaving == 2));
  CHECK(std::fabs(point->ball.middle[1] + 1.0 / 6) <= point->ball.radius + 1e-15);
  CHECK(std::fabs(point->ball.middle[3]) <= point->ball.radius);
  CHECK(point->still == std::array<bool, 4>{false, true, false, true});
  // In the middle of the segment there is none.
  CHECK_FALSE(filter::side_point_near<Bicubic>(segment.x, segment.y, segment.pair, {0, -1.0 / 6, 0, 0}));
}

TEST_CASE("side point: one parameter that moves outwards is enough", "[filter]") {
  const auto outside = corner_along_a_side(-1);
  REQUIRE(outside);
  CHECK(outside->on == Vec4{-0.5, -0.5, -0.5, -0.5});
  CHECK_FALSE(outside->enters);
  CHECK_FALSE(corner_along_a_side(1));  // the curve stays on the side r = 0
}

TEST_CASE("side point: a curve into a corner by terms of the third and fifth order", "[filter]") {
  const auto inside = corner_of_order_five(1);
  REQUIRE(inside);
  CHECK(inside->enters);
  CHECK((inside->leaving == 0 || inside->leaving == 2));
  CHECK(inside->rate == std::array<int, 4>{1, 1, 1, 1});
  CHECK(inside->still == std::array<bool, 4>{false, true, false, true});
  CHECK(inside->tube.upper >= 0x1p-8);
  const auto outside = corner_of_order_five(-1);
  REQUIRE(outside);
  CHECK_FALSE(outside->enters);
}

}  // namespace exsect::side_point_test
