#include "filter/ports.h"

#include <cmath>

#include "known_curve.h"

namespace exsect::ports_test {
namespace {

using filter::Biquadratic;
using testing::q;
using testing::Terms;

const Terms a = {{{1, 0}, 1}, {{0, 0}, q(-1, 2)}}, b = {{{0, 1}, 1}, {{0, 0}, q(-1, 2)}};

/// The double point in the middle, with its ports.
std::optional<filter::DoublePointOf<Biquadratic>> in_the_middle(const Terms& h) {
  const BezierPatch x = testing::graph(h), y = testing::larger_plane();
  return filter::double_point_near<Biquadratic>(x, y, filter::make_pair(x, y).value(), {0.01, -0.01, 0, 0},
                                                1e-7);
}

}  // namespace

TEST_CASE("ports: one on each of the four arcs of a crossing, on its lines", "[filter]") {
  // a^2 - 4 b^2: the lines a = 2 b and a = -2 b.
  const auto point = in_the_middle(a * a + Terms{{{0, 0}, -4}} * b * b);
  REQUIRE(point);
  REQUIRE(point->ports.size() == 4);
  std::array<int, 4> quadrants{};
  for (const auto& port : point->ports) {
    const double u = port.ball.middle[0], v = port.ball.middle[1];
    CHECK(std::fabs(std::fabs(u) - 2 * std::fabs(v)) <= 3 * port.ball.radius + 1e-15);
    ++quadrants[(u > 0 ? 1U : 0U) + (v > 0 ? 2U : 0U)];
    CHECK(std::fabs(port.side) == 0.5);
    // Away from the centre the parameter moves from the side to the other one.
    CHECK(port.ball.middle[port.parameter] * port.side < 0);
    CHECK(port.chord <= 1e-6);
  }
  for (const int count : quadrants) CHECK(count == 1);
}

TEST_CASE("ports: a touch point has none", "[filter]") {
  const auto point = in_the_middle(a * a + Terms{{{0, 0}, 4}} * b * b);
  REQUIRE(point);
  CHECK(point->ports.empty());
}

TEST_CASE("ports: all four or no point where a parameter does not move", "[filter]") {
  // b (a - b^2 / 4 - a b): along b = 0 v is constant.
  const auto point =
      in_the_middle(b * a + Terms{{{0, 0}, q(-1, 4)}} * b * b + Terms{{{0, 0}, -1}} * a * b * b);
  CHECK((!point || point->ports.size() == 4));
}

}  // namespace exsect::ports_test
