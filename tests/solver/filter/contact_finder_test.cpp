#include "filter/contact_finder.h"

#include "support/catch.h"
#include "support/families.h"
#include "support/known_curves.h"

namespace exsect::contact_finder_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

std::optional<filter::Contacts> contacts_of(const BezierPatch& x, const BezierPatch& y) {
  return filter::find_contacts<filter::Biquadratic>(x, y, filter::make_pair(x, y).value());
}

/// The plane z = a (X - X0) over a unit square whose corner (0,0) is (1, 1, 0), away from the square [0,1]^2.
BezierPatch beyond_the_corner() { return plane({1, 1, 0}, {1, 0, 1}, {0, 1, 1}); }

}  // namespace

TEST_CASE("contact finder: a side that two patches have in common", "[filter]") {
  const ExactCase c = families::shared_side({0, 1, 0});
  const auto found = contacts_of(c.x, c.y);
  REQUIRE(found);
  REQUIRE(found->sides.size() == 1);
  CHECK(found->corners.empty());  // its ends are no contacts of their own
  CHECK(found->sides[0].factor == 1);
  CHECK_FALSE(found->sides[0].path);
}

TEST_CASE("contact finder: a corner alone, and nothing", "[filter]") {
  const auto corner = contacts_of(plane_patch(), beyond_the_corner());
  REQUIRE(corner);
  CHECK(corner->sides.empty());
  REQUIRE(corner->corners.size() == 1);
  CHECK(corner->corners[0].x == 8);
  CHECK(corner->corners[0].y == 0);
  CHECK_FALSE(corner->corners[0].is_pole());
  const auto place = filter::place_of<filter::Biquadratic>(corner->corners[0]);
  CHECK(place == filter::Vec4{0.5, 0.5, -0.5, -0.5});
  const auto beside = contacts_of(plane_patch(), plane({q(17, 16), 1, 0}, {1, 0, 1}, {0, 1, 1}));
  REQUIRE(beside);
  CHECK(beside->empty());
  // Beside it by 2^-60 doubles do not see the difference: there may be more.
  CHECK_FALSE(contacts_of(plane_patch(), plane({1 + power_of_two(-60), 1, 0}, {1, 0, 1}, {0, 1, 1})));
}

TEST_CASE("contact finder: a corner on a side that is one point is a pole", "[filter]") {
  // (u v, v, 0) has the point (0, 0, 0) on v = 0.
  ControlNet c{};
  c[1][1] = {1, 0, 0};
  c[0][1] = {0, 1, 0};
  using filter::Bicubic;
  const auto x = filter::elevated<Bicubic>(BezierPatch::from_power_basis(c));
  const auto y = filter::elevated<Bicubic>(plane({0, 0, 0}, {-1, 0, 1}, {0, -1, 1}));
  const auto found = filter::find_contacts<Bicubic>(x, y, filter::make_pair_of<Bicubic>(x, y).value());
  REQUIRE(found);
  REQUIRE(found->corners.size() == 1);
  CHECK(found->corners[0].pole_of_x);
  CHECK_FALSE(found->corners[0].pole_of_y);
}

TEST_CASE("contact finder: a pole with a control point of weight zero", "[filter]") {
  // On v = 0 all control vectors are multiples of (Q, 1), by 1, 0 and 1; Q is no double.
  const Point pole = {q(1, 3), q(1, 5), q(1, 7)};
  std::vector<std::vector<HomogeneousPoint>> net(3);
  for (int i = 0; i < 3; ++i) {
    const Rational weight = i == 1 ? 0 : 1;
    net[static_cast<std::size_t>(i)] = {{weight * pole[0], weight * pole[1], weight * pole[2], weight},
                                        {pole[0] + i - 1, pole[1] + 1, pole[2], 1},
                                        {pole[0] + i - 1, pole[1] + 2, pole[2], 1}};
  }
  using K = filter::WeightedBiquadratic;
  const auto x = filter::elevated<K>(RationalPatch::from_homogeneous(net));
  const auto y = filter::elevated<K>(plane(pole, {-1, 0, 1}, {0, -1, 1}));
  const auto found = filter::find_contacts<K>(x, y, filter::make_pair_of<K>(x, y).value());
  REQUIRE(found);
  REQUIRE(found->corners.size() == 1);
  CHECK(found->corners[0].pole_of_x);
  CHECK_FALSE(found->corners[0].pole_of_y);
}

}  // namespace exsect::contact_finder_test
