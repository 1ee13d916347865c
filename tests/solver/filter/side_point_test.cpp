#include "filter/side_point.h"

#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <cmath>

#include "segment.h"
#include "support/power_nets.h"
#include "support/random_nets.h"

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

/// (u, v, 0) and (r, a s^order, s - r^2 + 1/2) meet on v = 0 and s = 0 at u = r = 1/√2: v = a s^order.
struct IrrationalPair {
  RationalPatch x, y;
};
IrrationalPair irrational_point(const Rational& a, int order) {
  using testing::Terms;
  return {RationalPatch(plane_patch()),
          testing::power_patch({Terms{{{1, 0}, 1}}, Terms{{{0, order}, a}},
                                Terms{{{0, 1}, 1}, {{2, 0}, -1}, {{0, 0}, Rational(1, 2)}}},
                               3)};
}

template <class K>
void check_irrational_point(const IrrationalPair& of, bool enters) {
  const auto x = filter::elevated<K>(of.x), y = filter::elevated<K>(of.y);
  const auto pair = filter::make_pair_of<K>(x, y).value();
  const double at = std::sqrt(0.5) - 0.5;
  const auto point = filter::side_point_near<K>(x, y, pair, {at, -0.5, at, -0.499999});
  REQUIRE(point);
  CHECK(point->on == Vec4{0, -0.5, 0, -0.5});
  CHECK(point->still[1]);
  CHECK(point->enters == enters);
  if (enters) CHECK(point->leaving == 3);
  const IntersectResult result = intersect(of.x, of.y);
  REQUIRE(result.status == Status::complete);
  CHECK(result.graph.arcs.size() == (enters ? 1 : 0));
  CHECK(std::ranges::count_if(result.graph.nodes, [&](const Node& node) {
          return node.on.size() == 2 && std::fabs(node.approx[0] - std::sqrt(0.5)) < 1e-12;
        }) == 1);
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

TEST_CASE("side point: a curve touches a side in an irrational point", "[filter]") {
  // To the second order it goes inside for a > 0, on one of both ways; to the third order on none for a < 0.
  for (const int order : {2, 3})
    for (const int a : {-1, 1}) {
      INFO("order " << order << ", a = " << a);
      const IrrationalPair pair = irrational_point(a, order);
      check_irrational_point<Bicubic>(pair, a > 0);
      random_pairs::Generator generator(61300);
      const auto map = random_nets::projective_map(generator);
      check_irrational_point<filter::WeightedBicubic>(
          {random_nets::image(pair.x, map), random_nets::image(pair.y, map)}, a > 0);
    }
}

}  // namespace exsect::side_point_test
