#include "filter/tube_offset.h"

#include "support/catch.h"

namespace exsect::filter::tube_offset_test {

TEST_CASE("an offset has a sign where its doubt leaves one", "[tube_offset]") {
  CHECK(TubeOffset(0.25).certain_sign() == 1);
  CHECK(TubeOffset(-0x1p-1000).certain_sign() == -1);
  CHECK(TubeOffset(0).certain_sign() == 0);
  CHECK(TubeOffset(0.25, 0.125).certain_sign() == 1);
  CHECK(TubeOffset(-0.25, 0.25).certain_sign() == 0);
  CHECK(TubeOffset(std::nan("")).certain_sign() == 0);
  CHECK(TubeOffset(1, std::nan("")).certain_sign() == 0);
  const TubeOffset difference = TubeOffset(0.5, 0x1p-10) - TubeOffset(0.25, 0x1p-12);
  CHECK(difference.approximation() == 0.25);
  CHECK(difference.upper_magnitude() > 0.25 + 0x1p-10 + 0x1p-12);
  CHECK(difference.upper_magnitude() < 0.25 + 0x1p-9);
}

TEST_CASE("offsets of balls on a tube are certain beyond their radii", "[tube_offset]") {
  TubeOf<Biquadratic> tube = {};
  tube.axis = 2;
  tube.centre = {0, 0, 0.125, 0};
  const auto at = [&](double r, double radius) {
    return offset(tube, BallOf<Biquadratic>{{0.3, 0.3, r, 0.3}, radius});
  };
  CHECK(at(0.375, 0).approximation() == 0.25);
  CHECK((at(0.375, 0x1p-20) - at(0.375 - 0x1p-18, 0x1p-20)).certain_sign() == 1);
  CHECK((at(0.375, 0x1p-20) - at(0.375 - 0x1p-19, 0x1p-20)).certain_sign() == 0);
  CHECK((at(0.375, 0) - at(0.375 + 0x1p-50, 0)).certain_sign() == 0);
}

}  // namespace exsect::filter::tube_offset_test
