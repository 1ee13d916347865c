#include "filter/algebraic_meeting.h"

#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/catch.h"
#include "support/power_nets.h"

namespace exsect::algebraic_meeting_test {
namespace {

using filter::algebraic_meeting;
using filter::ExactMeeting;
using filter::Vec4;

using Points = std::vector<std::vector<Point>>;

RationalPatch weighted(const Points& points) {
  return RationalPatch(points, {{1, 2, 1}, {1, 1, 3}, {2, 1, 1}});
}

/// Near the square over (u,v) in [0,1]^2 at height 0 with the side u = 0 along (0, v, v²).
Points sheet(std::mt19937_64& random) {
  std::uniform_int_distribution<int> number(-4, 4);
  Points net(3);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      net[i].push_back({Rational(static_cast<long>(i), 2), Rational(static_cast<long>(j), 2),
                        i == 0 ? Rational(j == 2 ? 1 : 0) : Rational(number(random), 16)});
  return net;
}

/// One whose corner r = s = 0 is `at`, and that crosses the sheet upwards.
Points standing(std::mt19937_64& random, const Point& at, const Point& along) {
  std::uniform_int_distribution<int> number(-2, 2);
  Points net(3);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Point jitter = {Rational(number(random), 32), Rational(number(random), 32),
                            Rational(number(random), 32)};
      const Rational a(static_cast<long>(i)), b(static_cast<long>(j));
      net[i].push_back(at + a * along + b * Point{0, Rational(1, 8), Rational(1, 3)} +
                       (i + j == 0 ? Point{0, 0, 0} : jitter));
    }
  return net;
}

}  // namespace

TEST_CASE("algebraic meeting: a corner on a side, at 2 - √3", "[algebraic_meeting]") {
  // On the side u = 0, with weights 1, 2, 1, y = (2 v - v²) / (1 + 2 v - 2 v²) is 1/3 there.
  std::mt19937_64 random(3);
  const Rational y(1, 3);
  const double v = 2 - std::sqrt(3.0);
  Points net = sheet(random);
  for (Point& p : net[0]) p[2] = 0;
  const RationalPatch flat = weighted(net);
  const RationalPatch other = weighted(standing(random, {0, y, 0}, {Rational(1, 3), 0, 0}));
  const auto meeting = algebraic_meeting(flat, other, {-0.5, v - 0.5, -0.5, -0.5}, {-0.5, 0, -0.5, -0.5});
  REQUIRE(meeting);
  CHECK(std::fabs(meeting->at[1] + 0.5 - v) < 1e-14);
  CHECK(meeting->at[0] == -0.5);
  CHECK(meeting->at[2] == -0.5);
  CHECK(meeting->at[3] == -0.5);
  CHECK(meeting->still == std::array<bool, 4>{false, false, false, false});
  CHECK_FALSE(meeting->exact);  // nobody asks for it
  // The curve that ends there, or passes outside.
  const IntersectResult result = intersect(flat, other);
  CHECK(result.status == Status::complete);
  CHECK(std::ranges::count_if(result.graph.nodes, [&](const Node& node) {
          return node.on.size() == 3 && node.box[1].lower <= from_double(v + 1e-12) &&
                 node.box[1].upper >= from_double(v - 1e-12);
        }) == 1);
  // Exchanged; not there; beside the side.
  const auto exchanged = algebraic_meeting(other, flat, {-0.5, -0.5, -0.5, v - 0.5}, {-0.5, -0.5, -0.5, 0});
  REQUIRE(exchanged);
  CHECK(exchanged->at == Vec4{-0.5, -0.5, -0.5, meeting->at[1]});
  CHECK_FALSE(algebraic_meeting(flat, other, {-0.5, v - 0.4, -0.5, -0.5}, {-0.5, 0, -0.5, -0.5}));
  const RationalPatch beside = weighted(standing(random, {power_of_two(-60), y, 0}, {Rational(1, 3), 0, 0}));
  CHECK_FALSE(algebraic_meeting(flat, beside, {-0.5, v - 0.5, -0.5, -0.5}, {-0.5, 0, -0.5, -0.5}));
}

TEST_CASE("algebraic meeting: sides that are not in one plane meet", "[algebraic_meeting]") {
  std::mt19937_64 random(4);
  Points net = sheet(random);
  const RationalPatch x(net);
  // y(0,s) = (2s² - 1, s, 1/2) is (0, v, v²) at s = v = 1/√2.
  Points other(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational a(static_cast<long>(i));
    other[i] = {Point{-1 + a / 5, a / 7, Rational(1, 2) + a},
                Point{-1 + a / 5, Rational(1, 2), Rational(1, 2) + a},
                Point{1 + a / 5, 1 - a / 9, Rational(1, 2) + a}};
  }
  const RationalPatch y(other, {{1, 1, 1}, {1, 2, 1}, {1, 1, 1}});
  const double root = std::sqrt(0.5);
  const auto meeting = algebraic_meeting(x, y, {-0.5, root - 0.5, -0.5, root - 0.5}, {-0.5, 0, -0.5, 0});
  REQUIRE(meeting);
  CHECK(std::fabs(meeting->at[1] + 0.5 - root) < 1e-15);
  CHECK(std::fabs(meeting->at[3] + 0.5 - root) < 1e-15);
  CHECK(meeting->still == std::array<bool, 4>{false, false, false, false});
  // A side and a rational corner of its own patch are no question; an inner corner is not asked here.
  CHECK_FALSE(algebraic_meeting(x, y, {-0.5, 0, 0, 0}, {-0.5, 0, 0, 0}));
  CHECK_FALSE(algebraic_meeting(x, y, {-0.5, -0.5, 0, 0}, {-0.5, -0.5, 0, 0}));
  CHECK_FALSE(algebraic_meeting(x, x, {-0.5, 0.1, -0.5, 0.1}, {-0.5, 0, -0.5, 0}));  // a common side
}

TEST_CASE("algebraic meeting: its parameters in a field where the curve touches a side",
          "[algebraic_meeting]") {
  // (u, v, 0) and (r, s^3 + t (s - p), s - p), p = r^2 - 1/2: v = s^3 at s = p, all 0 for r = 1/√2.
  using testing::Terms;
  const Rational t(3, 7), half(1, 2);
  const Terms p = {{{0, 1}, 1}, {{2, 0}, -1}, {{0, 0}, half}};
  const Terms second = {{{0, 3}, 1}, {{0, 1}, t}, {{2, 0}, -t}, {{0, 0}, t * half}};
  const RationalPatch x = testing::power_patch({Terms{{{1, 0}, 1}}, Terms{{{0, 1}, 1}}, Terms{}}, 1);
  const RationalPatch y = testing::power_patch({Terms{{{1, 0}, 1}}, second, p}, 3);
  const double root = std::sqrt(0.5) - 0.5;
  for (const bool exchanged : {false, true}) {
    INFO("exchanged " << exchanged);
    const auto meeting = exchanged ? algebraic_meeting(y, x, {root, -0.5, root, -0.5}, {0, -0.5, 0, -0.5})
                                   : algebraic_meeting(x, y, {root, -0.5, root, -0.5}, {0, -0.5, 0, -0.5});
    REQUIRE(meeting);
    const std::size_t v = exchanged ? 3 : 1, s = exchanged ? 1 : 3;
    CHECK(meeting->still[v]);
    CHECK_FALSE(meeting->still[s]);
    REQUIRE(meeting->exact);
    for (const std::size_t j : {0, 2}) {
      const FieldNumber& w = (*meeting->exact)[j];
      CHECK(2 * w * w == FieldNumber(1));
      CHECK(sign(w) > 0);
    }
    CHECK((*meeting->exact)[v].is_zero());
    CHECK((*meeting->exact)[s].is_zero());
  }
}

}  // namespace exsect::algebraic_meeting_test
