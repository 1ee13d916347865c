// Sections of patches by planes and quadrics: equations and turning conditions against points of the curves.
#include "shape/section.h"

#include <exsect/algebra/real_algebraic.h>

#include "support/catch.h"

namespace exsect::section_test {
namespace {

/// x² + y² = 1, x, y >= 0, 0 <= z <= 2.
RationalPatch cylinder() {
  return RationalPatch({{{1, 0, 0}, {1, 0, 2}}, {{1, 1, 0}, {1, 1, 2}}, {{0, 1, 0}, {0, 1, 2}}},
                       {{1, 1}, {1, 1}, {2, 2}});
}

/// z = height + slope x over [-1,2]^2.
RationalPatch plane(const Rational& height, const Rational& slope) {
  const auto point = [&](const Rational& a, const Rational& b) { return Point{a, b, height + slope * a}; };
  return RationalPatch(
      std::vector<std::vector<Point>>{{point(-1, -1), point(-1, 2)}, {point(2, -1), point(2, 2)}});
}

const Rectangle whole = {};

}  // namespace

TEST_CASE("section: equations vanish at all common points, and there are both") {
  const auto both = sections(cylinder(), plane(Rational(1, 2), Rational(1, 4)));
  REQUIRE(both.size() == 2);
  CHECK(both[0].first == 0);
  CHECK(both[1].first == 2);
  for (const Rational& u : {Rational(0), Rational(1, 3), Rational(1)}) {
    const Rational x = (1 - u * u) / (1 + u * u);
    const Rational y = 2 * u / (1 + u * u);
    const Rational v = (Rational(1, 2) + x / 4) / 2;
    CHECK(both[0].f(u, v) == 0);
    CHECK(both[0].f(u, v + Rational(1, 9)) != 0);
    CHECK(both[1].f((x + 1) / 3, (y + 1) / 3) == 0);
    CHECK(both[1].f((x + 1) / 3, (y + 2) / 3) != 0);
  }
  CHECK(sections(cylinder(), cylinder()).empty());
}

TEST_CASE("section: what is constant, and what is not") {
  for (const auto& section : sections(cylinder(), plane(Rational(1, 2), 0))) {
    const std::vector<Rectangle> boxes = {{{0, 1}, {Rational(1, 4), Rational(1, 3)}}};
    if (section.first == 0) CHECK(is_constant_in(section, 1, boxes));
    for (const std::size_t other : {0U, 2U, 3U}) CHECK_FALSE(is_constant_in(section, other, boxes));
  }
  for (const auto& section : sections(cylinder(), plane(Rational(1, 2), Rational(1, 1000))))
    for (std::size_t i = 0; i < 4; ++i) CHECK_FALSE(is_constant_in(section, i, {whole}));
}

TEST_CASE("section: what turns on a side, and what does not") {
  const Side at_x = {Parameter::u, 0};  // (1, 0, z)
  const Side at_y = {Parameter::u, 1};  // (0, 1, z)
  const auto section = sections(cylinder(), plane(Rational(1, 2), Rational(1, 4))).at(0);
  CHECK(turns_on_side(section, 1, at_x, {0, 1}));        // the height, as x
  CHECK(turns_on_side(section, 2, at_x, {0, 1}));        // x in the plane
  CHECK_FALSE(turns_on_side(section, 3, at_x, {0, 1}));  // y in the plane
  CHECK_FALSE(turns_on_side(section, 0, at_x, {0, 1}));
  CHECK(turns_on_side(section, 3, at_y, {0, 1}));
  CHECK_FALSE(turns_on_side(section, 1, at_y, {0, 1}));
  CHECK_FALSE(turns_on_side(section, 1, at_x, {0, Rational(1, 4)}));  // the point is not there
  CHECK_FALSE(turns_on_side(section, 1, {Parameter::r, 0}, {0, 1}));  // a side of the other patch
  const auto near = sections(cylinder(), RationalPatch(std::vector<std::vector<Point>>{
                                             {{-1, -1, 0}, {-1, 2, Rational(3, 1000000)}},
                                             {{2, -1, 3}, {2, 2, 3 + Rational(3, 1000000)}}}));
  CHECK_FALSE(turns_on_side(near.at(0), 1, at_x, {0, 1}));
}

}  // namespace exsect::section_test
