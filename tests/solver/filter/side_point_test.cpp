#include "filter/side_point.h"

#include "segment.h"

namespace exsect::side_point_test {
namespace {

using filter::Bicubic;
using filter::Vec4;
using testing::Segment;

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

}  // namespace exsect::side_point_test
