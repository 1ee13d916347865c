#include "filter/lone_corner.h"

#include <exsect/solver/intersect_rational.h>

#include <set>

#include "filter/contact_finder.h"
#include "support/catch.h"
#include "support/known_curves.h"
#include "support/power_nets.h"
#include "support/random_nets.h"

namespace exsect::lone_corner_test {
namespace {

using filter::Bicubic;
using filter::CornerNet;
using testing::power_patch;
using testing::Terms;

/// Of the corner (0,0).
CornerNet net_of(const RationalPatch& patch) {
  return {filter::control_vectors(filter::elevated<Bicubic>(patch)), filter::kCornerPlace};
}

bool meet_alone(const RationalPatch& x, const RationalPatch& y) {
  const bool result = filter::meet_in_own_places(net_of(x), net_of(y));
  CHECK(filter::meet_in_own_places(net_of(y), net_of(x)) == result);
  CHECK(filter::meet_in_own_places(net_of(x.transposed()), net_of(y)) == result);
  return result;
}

const Terms kNone, kMinus = {{{0, 0}, -1}}, kU = {{{1, 0}, 1}}, kV = {{{0, 1}, 1}};

/// Whether x = y somewhere on a grid, but for the corner (0,0) of both.
bool meet_on_grid(const RationalPatch& x, const RationalPatch& y, int n) {
  std::set<Point> of_x;
  const auto visit = [n](const RationalPatch& patch, const auto& use) {
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) use(i + j == 0, patch(Rational(i, n), Rational(j, n)));
  };
  bool found = false;
  const Point corner = x(0, 0);
  visit(x, [&](bool is_corner, const Point& p) {
    found = found || (!is_corner && p == corner);
    of_x.insert(p);
  });
  visit(y, [&](bool is_corner, const Point& p) { found = found || (!is_corner && of_x.contains(p)); });
  return found;
}

}  // namespace

TEST_CASE("lone corner: planes through it that touch both nets", "[filter]") {
  // In one plane, in opposite quadrants; one side in the other's plane; sides along one line, opposite.
  CHECK(meet_alone(power_patch({kU, kV, kNone}, 3), power_patch({kMinus * kU, kMinus * kV, kNone}, 3)));
  CHECK(meet_alone(power_patch({kU, kV, kNone}, 3), power_patch({kMinus * kU, kNone, kV}, 3)));
  CHECK(meet_alone(power_patch({kU, kV, kNone}, 3), power_patch({kMinus * kU, kNone, kMinus * kV}, 3)));
  // Zero derivatives in the corner.
  CHECK(meet_alone(power_patch({kU * kU, kV * kV * kV, kU * kV}, 3),
                   power_patch({kMinus * kU, kMinus * kV, kNone}, 3)));
}

TEST_CASE("lone corner: not where something else is common", "[filter]") {
  CHECK_FALSE(
      meet_alone(power_patch({kU, kV, kNone}, 3), power_patch({kU, kMinus * kV, kNone}, 3)));  // a side
  CHECK_FALSE(meet_alone(power_patch({kU, kV, kNone}, 3), power_patch({kU, kNone, kV}, 3)));
  CHECK_FALSE(meet_alone(power_patch({kU, kV, kNone}, 3), power_patch({kV, kU, kNone}, 3)));
  // (u - v, u v, 0) passes along the line of the other one's side.
  CHECK_FALSE(
      meet_alone(power_patch({kU + kMinus * kV, kU * kV, kNone}, 3), power_patch({kU, kMinus * kV, kV}, 3)));
  // A side that is the corner's point belongs to it only as a pole.
  const CornerNet pole = net_of(power_patch({kU, kU * kV, kNone}, 3));
  const CornerNet other = net_of(power_patch({kMinus * kU, kNone, kV}, 3));
  CHECK_FALSE(filter::meet_in_own_places(pole, other));
  CHECK(filter::meet_in_own_places({pole.points, filter::side_places(0)}, other));
}

TEST_CASE("lone corner: random patches, and common points on a grid", "[filter]") {
  int proved = 0, met = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    random_nets::Generator generator(seed);
    const auto degree = [&] { return static_cast<int>(random_pairs::integer(generator, 1, 2)); };
    const int m = degree(), n = degree();
    random_nets::Net first = random_nets::tiny(generator, m, n);
    random_nets::Net second = random_nets::chosen(generator, first, degree(), degree());
    // On both sides of a plane, which some points are on, with the corner in it.
    for (auto& row : first)
      for (Point& p : row) p[0] = abs(p[0]);
    for (auto& row : second)
      for (Point& p : row) p[0] = -abs(p[0]);
    for (random_nets::Net* net : {&first, &second}) (*net)[0][0] = {0, 0, 0};
    try {
      const RationalPatch x = random_nets::weighted_by_one_or_two(generator, first);
      const RationalPatch y = random_nets::weighted_by_one_or_two(generator, second);
      const auto of = [](const RationalPatch& patch) -> CornerNet {
        return {filter::control_vectors(filter::elevated<filter::WeightedBicubic>(patch)),
                filter::kCornerPlace};
      };
      const bool is_proved = filter::meet_in_own_places(of(x), of(y));
      const bool is_met = meet_on_grid(x, y, 4);
      INFO("seed " << seed);
      CHECK_FALSE((is_proved && is_met));
      CHECK(filter::meet_in_own_places(of(y), of(x)) == is_proved);
      proved += is_proved ? 1 : 0;
      met += is_met ? 1 : 0;
    } catch (const PatchError&) {  // no patch
    }
  }
  CHECK(proved >= 10);
  CHECK(met >= 10);
}

TEST_CASE("lone corner: one tangent plane, sides along one line, in every position", "[filter]") {
  // (u/4, 0, v) and (r, r^2 - 2 r^3, -s): the second side is on one side of the first one's line for r < 1/2,
  // and on it in the end of the first half.
  const RationalPatch x = power_patch({Terms{{{1, 0}, Rational(1, 4)}}, kNone, kV}, 3);
  const auto along = [](const Terms& w, bool reversed) {
    return reversed ? Terms{{{0, 0}, 1}} + kMinus * w : w;
  };
  for (const bool exchanged : {false, true})
    for (const bool first : {false, true})
      for (const bool second : {false, true}) {
        const Terms r = along(exchanged ? kV : kU, first), t = along(exchanged ? kU : kV, second);
        const RationalPatch moved = power_patch({r, r * r + Terms{{{0, 0}, -2}} * r * r * r, kMinus * t}, 3);
        const auto a = filter::elevated<Bicubic>(x), b = filter::elevated<Bicubic>(moved);
        const auto pair = filter::make_pair_of<Bicubic>(a, b).value();
        const auto contacts = filter::find_contacts<Bicubic>(a, b, pair).value();
        REQUIRE(contacts.corners.size() == 1);
        CHECK(filter::lone_reach<Bicubic>(a, b, contacts.corners.front()) == 0.25);
        for (const IntersectResult& result : {intersect(x, moved), intersect(moved, x)}) {
          REQUIRE(result.status == Status::complete);
          CHECK(result.graph.isolated_points.size() == 1);
          CHECK(result.graph.arcs.empty());
        }
      }
}

}  // namespace exsect::lone_corner_test
