#include "filter/corner_contact.h"

#include <exsect/solver/intersect_rational.h>

#include "filter/contact_finder.h"
#include "support/catch.h"
#include "support/exact_oracle.h"
#include "support/known_curves.h"
#include "support/random_nets.h"

namespace exsect::corner_contact_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves
using filter::Bicubic;

struct Solved {
  bool in_contacts_only;
  filter::CornerContact corner;
};
/// Of patches with one common corner.
Solved solved(const BezierPatch& first, const BezierPatch& second) {
  const auto x = filter::elevated<Bicubic>(first);
  const auto y = filter::elevated<Bicubic>(second);
  const auto pair = filter::make_pair_of<Bicubic>(x, y).value();
  const auto contacts = filter::find_contacts<Bicubic>(x, y, pair).value();
  REQUIRE(contacts.corners.size() == 1);
  filter::TreesOf<Bicubic> trees{filter::PatchTreeOf<Bicubic>(pair.x, pair.net_error),
                                 filter::PatchTreeOf<Bicubic>(pair.y, pair.net_error)};
  long boxes = 0;
  return {filter::meet_in_contacts_only(pair, trees, contacts, boxes), contacts.corners[0]};
}

/// (u, v^2, u v): the control point next to the corner (0, 0) along v is the corner.
BezierPatch still_along_v() {
  ControlNet c{};
  c[1][0] = {1, 0, 0};
  c[0][2] = {0, 1, 0};
  c[1][1] = {0, 0, 1};
  return BezierPatch::from_power_basis(c);
}

}  // namespace

TEST_CASE("corner contact: control points that are the corner are left out, in every position", "[filter]") {
  const BezierPatch y = plane({0, 0, 0}, {-1, 0, 1}, {0, -1, 1});
  for (const bool exchanged : {false, true})
    for (const bool first : {false, true})
      for (const bool second : {false, true}) {
        BezierPatch x = exchanged ? still_along_v().exchanged() : still_along_v();
        if (first) x = x.reversed_first();
        if (second) x = x.reversed_second();
        const filter::Repeated along = exchanged ? filter::Repeated{1, 0} : filter::Repeated{0, 1};
        const Solved xy = solved(x, y);
        CHECK(xy.in_contacts_only);
        CHECK(xy.corner.repeated_of_x == along);
        CHECK(xy.corner.repeated_of_y == filter::Repeated{});
        const Solved yx = solved(y, x);
        CHECK(yx.in_contacts_only);
        CHECK(yx.corner.repeated_of_y == along);
      }
}

TEST_CASE("corner contact: what else begins in the corner is not overlooked", "[filter]") {
  // On u = 0, (0, v^2, 0), is half of the side r = 0, (0, 2 s, 0).
  CHECK_FALSE(solved(still_along_v(), plane({0, 0, 0}, {-1, 0, 0}, {0, 2, 0})).in_contacts_only);
  // The curve u = v^2 = 2 r, s = v^3, with (2 r, 2 r, s), is inside of both.
  CHECK_FALSE(solved(still_along_v(), plane({0, 0, 0}, {2, 2, 0}, {0, 0, 1})).in_contacts_only);
}

TEST_CASE("corner contact: directions that fill nearly a half space", "[filter]") {
  // (u - v, v h, 0) and (0, -r - s h, s - r): d = (h / 2, 1, 0) is within h / 2 of being perpendicular to all
  // of x.
  for (const long bits : {1, 3, 5}) {
    const Rational h = power_of_two(-bits);
    CHECK(solved(plane({0, 0, 0}, {1, 0, 0}, {-1, h, 0}), plane({0, 0, 0}, {0, -1, -1}, {0, -h, 1}))
              .in_contacts_only);
  }
  // (u - v, 0, v) has the points (0, 0, t) of the other one.
  CHECK_FALSE(solved(plane({0, 0, 0}, {1, 0, 0}, {-1, 0, 1}), plane({0, 0, 0}, {0, -1, 1}, {0, 1, 1}))
                  .in_contacts_only);
}

TEST_CASE("corner contact: small integers with a zero derivative in a corner, and the oracle", "[filter]") {
  const auto check = [](const RationalPatch& x, const RationalPatch& y) {
    const IntersectResult result = intersect(x, y);
    REQUIRE(result.status == Status::complete);
    CHECK(exact_oracle::compare(x, y, result.graph).difference == "");
  };
  for (const std::uint64_t seed : {576, 741, 946}) {
    CAPTURE(seed);
    random_nets::Generator generator(seed);
    random_nets::Nets nets;
    nets.x = random_nets::small(generator, 3, 3);
    nets.y = random_nets::small(generator, 3, 3);
    check(nets.first(), nets.second());
  }
  for (const std::uint64_t seed : {359, 730, 851}) {
    CAPTURE(seed);
    random_nets::Generator generator(seed);
    const auto of_x = random_nets::small(generator, 2, 2);
    const auto of_y = random_nets::small(generator, 2, 2);
    const RationalPatch x = random_nets::weighted(generator, of_x);
    check(x, random_nets::weighted(generator, of_y));
  }
}

}  // namespace exsect::corner_contact_test
