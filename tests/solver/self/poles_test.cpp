// Poles of round patches, and what is near them: pieces that are injective, or apart, but for the pole; cones
// that meet themselves are neither.
#include "self/poles.h"

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::poles_test {
namespace {

/// An eighth of the unit sphere: u = 1 is the pole (0,0,1).
RationalPatch octant() {
  return RationalPatch({{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                        {{1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                        {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}},
                       {{1, 1, 2}, {1, 1, 2}, {2, 2, 4}});
}

/// With the apex (0,0,0) at u = 0, over a plane cubic that crosses itself.
RationalPatch crossing_cone() {
  const Point apex = {0, 0, 0};
  return RationalPatch({{apex, apex, apex, apex}, {{0, 0, 2}, {3, 2, 2}, {-2, 2, 2}, {1, 0, 2}}});
}

RationalPatch piece_of(const RationalPatch& x, const ParameterRectangle& where) {
  return x.restricted_to(where.u.lower, where.u.upper, where.v.lower, where.v.upper);
}

}  // namespace

TEST_CASE("poles: sides that are one point") {
  const auto poles = poles_of(octant());
  REQUIRE(poles.size() == 1);
  CHECK(poles[0].fixed == 0);
  CHECK(poles[0].value == 1);
  CHECK(poles[0].point == Point{0, 0, 1});
  const auto exchanged = poles_of(octant().transposed().restricted_to(0, 1, 1, 0));
  REQUIRE(exchanged.size() == 1);
  CHECK(exchanged[0].fixed == 1);
  CHECK(exchanged[0].value == 0);
  const ParameterRectangle upper = {{Rational(1, 2), 1}, {0, 1}}, lower = {{0, Rational(1, 2)}, {0, 1}};
  CHECK(reaches(upper, poles[0]));
  CHECK_FALSE(reaches(lower, poles[0]));
  random_nets::Generator generator(1);
  CHECK(poles_of(random_nets::scattered(generator, {3, 2, 1, 1}).first()).empty());
}

TEST_CASE("poles: a sphere is injective but for its pole, and pieces are apart but for it") {
  const RationalPatch x = octant();
  const Pole pole = poles_of(x).at(0);
  const Rational half(1, 2), third(1, 3), quarter(1, 4);
  CHECK(is_injective_but_for(pole, piece_of(x, {{3 * quarter, 1}, {quarter, half}})));
  CHECK(is_injective_but_for(pole, piece_of(x, {{1 - quarter / 16, 1}, {quarter, half}})));
  const RationalPatch a = piece_of(x, {{half, 1}, {0, third}}), b = piece_of(x, {{quarter, 1}, {half, 1}});
  CHECK(are_apart_but_for(pole, a, b));
  CHECK(are_apart_but_for(pole, b, a));
  CHECK_FALSE(are_apart_but_for(pole, a, a));
  CHECK_FALSE(are_apart_but_for(pole, piece_of(x, {{half, 1}, {0, half}}), b));
}

TEST_CASE("poles: a cone that crosses itself is neither injective nor apart from itself") {
  const RationalPatch x = crossing_cone();
  const Pole pole = poles_of(x).at(0);
  CHECK_FALSE(is_injective_but_for(pole, x));
  CHECK_FALSE(is_injective_but_for(pole, piece_of(x, {{0, Rational(1, 1 << 20)}, {0, 1}})));
  // The double point of the cubic is at v = 1/2 -+ sqrt(3)/4, about 0.067 and 0.933.
  const RationalPatch a = piece_of(x, {{0, 1}, {0, Rational(1, 10)}});
  CHECK_FALSE(are_apart_but_for(pole, a, piece_of(x, {{0, 1}, {Rational(9, 10), 1}})));
  CHECK(are_apart_but_for(pole, a, piece_of(x, {{0, 1}, {Rational(19, 20), 1}})) ==
        are_apart_but_for(pole, piece_of(x, {{0, 1}, {Rational(19, 20), 1}}), a));
  CHECK(is_injective_but_for(pole, a));
}

TEST_CASE("poles: the side is one node of all its pairs") {
  const Node node = pole_node(poles_of(octant()).at(0));
  CHECK(node.on == std::vector<Side>{{Parameter::u, 1}, {Parameter::r, 1}});
  CHECK(node.free == std::vector<Parameter>{Parameter::v, Parameter::s});
  CHECK(node.point == std::array<double, 3>{0, 0, 1});
  CHECK(node.box[0].lower == 1);
  CHECK(node.box[1].upper == 1);
}

}  // namespace exsect::poles_test
