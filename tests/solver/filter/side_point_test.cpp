#include "filter/side_point.h"

#include "segment.h"

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

}  // namespace exsect::side_point_test
