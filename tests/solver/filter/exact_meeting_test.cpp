#include "filter/exact_meeting.h"

#include "segment.h"

namespace exsect::exact_meeting_test {
namespace {

using filter::Bicubic;
using filter::Vec4;
using testing::Segment;

}  // namespace

TEST_CASE("exact meeting: with the sides exactly and the rest enclosed", "[filter]") {
  const Segment segment;
  const auto meeting =
      filter::exact_meeting<Bicubic>(segment.x, segment.y, {0.5, -1.0 / 6, 0.5, 0}, {0.5, 0, 0.5, 0});
  REQUIRE(meeting);
  CHECK(meeting->at[0] == 0.5);
  CHECK(meeting->at[2] == 0.5);
  CHECK(std::fabs(meeting->at[1] + 1.0 / 6) <= meeting->radius + 1e-16);
  CHECK(meeting->still == std::array<bool, 4>{false, true, false, true});
  // On the other sides of both, but not on two that do not meet.
  CHECK(filter::exact_meeting<Bicubic>(segment.x, segment.y, {-0.5, -1.0 / 6, -0.5, 0}, {-0.5, 0, -0.5, 0}));
  CHECK_FALSE(
      filter::exact_meeting<Bicubic>(segment.x, segment.y, {0.5, -1.0 / 6, -0.5, 0}, {0.5, 0, -0.5, 0}));
}

}  // namespace exsect::exact_meeting_test
