#include "self/known_pinches.h"

#include "support/catch.h"
#include "support/polynomial_patch.h"
#include "support/random_nets.h"

namespace exsect::known_pinches_test {
namespace {

using random_nets::Generator;

/// On the side u = 0 the cubic with the control points 0, (2,1,0), (2,-1,0)... turns at v = 1/2 in a cusp.
RationalPatch with_cusp(Generator& generator) {
  random_nets::Net net = random_nets::doubles(generator, 3, 3);
  net[0] = {{0, 0, 0}, {2, 1, 1}, {1, 2, 0}, {3, 3, 1}};
  return RationalPatch(net);
}

std::vector<KnownPinch> pinches_of(const RationalPatch& patch) { return known_pinches(patch, {}); }

bool has(const std::vector<KnownPinch>& found, std::size_t fixed, const Rational& value, const Rational& at,
         const std::array<bool, 2>& rests) {
  return std::ranges::any_of(found, [&](const KnownPinch& p) {
    return p.fixed == fixed && p.value == value && p.at == RealAlgebraic(at) && p.rests == rests;
  });
}

}  // namespace

TEST_CASE("known pinches: cusps of sides, corners, and images") {
  Generator generator(3);
  const RationalPatch x = with_cusp(generator);
  // x_v = 3/4 (P3 + P2 - P1 - P0) at v = 1/2.
  random_nets::Net net(4, std::vector<Point>(4));
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = x.point(i, j);
  net[0][3] = net[0][0] + net[0][1] - net[0][2];
  const RationalPatch cusp(net);
  CHECK(has(pinches_of(cusp), 0, 0, Rational(1, 2), {false, true}));
  CHECK(std::ranges::none_of(pinches_of(cusp), &KnownPinch::is_on_straight_line));
  CHECK(has(pinches_of(cusp.transposed()), 1, 0, Rational(1, 2), {true, false}));
  CHECK(has(pinches_of(cusp.restricted_to(1, 0, 0, Rational(3, 4))), 0, 1, Rational(2, 3), {false, true}));
  CHECK(has(pinches_of(random_nets::image(cusp, random_nets::projective_map(generator))), 0, 0,
            Rational(1, 2), {false, true}));
  net[0][3] = {3, 3, 1};
  net[3][2] = net[3][3];  // x_v = 0 in the corner (1,1)
  const auto corner = pinches_of(RationalPatch(net));
  CHECK(has(corner, 0, 1, 1, {false, true}));
  CHECK(has(corner, 1, 1, 1, {false, true}));
  CHECK(pinches_of(RationalPatch(random_nets::doubles(generator, 3, 2))).empty());
  net[1] = net[0];  // the whole side u = 0, x_u = 0
  CHECK_FALSE(std::ranges::any_of(pinches_of(RationalPatch(net)),
                                  [](const KnownPinch& p) { return p.fixed == 0 && p.value == 0; }));
}

TEST_CASE("known pinches: on sides that are straight in space, also with weights") {
  Generator generator(5);
  random_nets::Net net = random_nets::doubles(generator, 3, 2);
  const Point a = {1, 2, -1}, b = {3, -1, 2};
  const auto on_line = [&](const Rational& t) { return (1 - t) * a + t * b; };
  net[0] = {on_line(0), on_line(2), on_line(Rational(1, 3))};
  const auto straight = [](const RationalPatch& x) {
    const auto found = pinches_of(x);
    REQUIRE(found.size() == 1);
    CHECK(found[0].fixed == 0);
    CHECK(found[0].rests == std::array{false, true});
    return found[0].is_on_straight_line;
  };
  CHECK(straight(RationalPatch(net)));
  CHECK(straight(random_nets::weighted(generator, net)));
}

TEST_CASE("known pinches: which rectangles contain one with an irrational parameter") {
  const KnownPinch pinch{1, 1, real_roots(Polynomial{-1, 0, 2}, 0, 1).front(), {false, false}};
  CHECK(contains({{Rational(7, 10), Rational(71, 100)}, {Rational(1, 2), 1}}, pinch));
  CHECK_FALSE(contains({{Rational(7, 10), Rational(707, 1000)}, {Rational(1, 2), 1}}, pinch));
  CHECK_FALSE(contains({{Rational(7, 10), Rational(71, 100)}, {0, Rational(1, 2)}}, pinch));
}

/// (a (u^2 + u - 1 - a^2), a^2 + u, u^2) with a = v - 1/2, a mirror image of itself: x_v = 0 where u^2 + u
/// = 1.
TEST_CASE("known pinches: inside, on a line that is simple") {
  const BivariatePolynomial u = BivariatePolynomial::r(), one = BivariatePolynomial::constant(1),
                            a = BivariatePolynomial::s() - BivariatePolynomial::constant(Rational(1, 2));
  const RationalPatch x = testing::patch_of({a * (u * u + u - one - a * a), a * a + u, u * u});
  CHECK(known_pinches(x, {}).empty());
  for (const auto& [patch, place] : {std::pair(x, std::array{0.618, 0.5}), {x.transposed(), {0.5, 0.618}}}) {
    const std::size_t fixed = place[1] == 0.5 ? 1 : 0;
    const auto found = known_pinches(patch, {place});
    REQUIRE(found.size() == 1);
    CHECK(found[0].fixed == fixed);
    CHECK(found[0].value == Rational(1, 2));
    CHECK(sign_at(Polynomial{-1, 1, 1}, found[0].at) == 0);
    CHECK(found[0].rests == std::array{fixed == 0, fixed == 1});
    CHECK_FALSE(found[0].is_on_side());
  }
  CHECK(known_pinches(x, {{0.618, 0.5000001}}).empty());
}

}  // namespace exsect::known_pinches_test
