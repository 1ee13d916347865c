// Closed curves that doubles see in a small box alone.
#include "filter/magnified_box.h"

#include <exsect/solver/intersect_rational.h>

#include "filter/filtered_intersection.h"
#include "support/catch.h"
#include "support/counted_case.h"
#include "support/power_nets.h"
#include "support/random_nets.h"

namespace exsect::magnified_box_test {
namespace {

using testing::power_patch, testing::Terms;

/// (u - c)² + a (v - d)² - level
Terms ellipse(const Rational& c, const Rational& d, const Rational& a, const Rational& level) {
  return {
      {{0, 0}, c * c + a * d * d - level}, {{1, 0}, -2 * c}, {{2, 0}, 1}, {{0, 1}, -2 * a * d}, {{0, 2}, a}};
}

/// (u, v, h g): where g > 0 it is zero where h is.
RationalPatch bicubic_graph(const Terms& h) {
  const Terms g = {
      {{0, 0}, 1}, {{1, 0}, Rational(1, 3)}, {{0, 1}, Rational(-2, 7)}, {{1, 1}, Rational(1, 5)}};
  return power_patch({Terms{{{1, 0}, 1}}, Terms{{{0, 1}, 1}}, h * g}, 3);
}

/// (u, v, h / w) with a weight w of bidegree (1,1).
RationalPatch weighted_graph(const Terms& h) {
  const Terms w = {
      {{0, 0}, 1}, {{1, 0}, Rational(1, 4)}, {{0, 1}, Rational(1, 3)}, {{1, 1}, Rational(-1, 6)}};
  testing::PowerNet net(3, std::vector<HomogeneousPoint>(3));
  for (const auto& [k, p] : w) {
    net[k.first + 1][k.second][0] += p;
    net[k.first][k.second + 1][1] += p;
    net[k.first][k.second][3] += p;
  }
  for (const auto& [k, p] : h) net[k.first][k.second][2] += p;
  return testing::power_patch(net, 0, 1);
}

/// z = 0 over a square around that of the graphs, turned.
RationalPatch ground() { return testing::plane({-1, Rational(-3, 2), 0}, {3, 1, 0}, {-1, 4, 0}); }

/// In a tilted space.
IntersectResult solved(const RationalPatch& x, const RationalPatch& y) {
  const random_nets::ProjectiveMap turn = {{{Rational(3, 5), Rational(4, 5), 0, Rational(1, 7)},
                                            {Rational(-4, 5), Rational(3, 5), Rational(1, 2), 0},
                                            {Rational(1, 3), 0, 1, Rational(-2, 9)},
                                            {0, 0, 0, 1}}};
  return intersect(random_nets::image(x, turn), random_nets::image(y, turn));
}

using Make = RationalPatch (*)(const Terms&);

void check_loop(Make make, int bits) {
  INFO("2^-" << bits);
  const Rational c(2, 7), d(5, 9), a(3, 4), e = power_of_two(-bits);
  const RationalPatch x = make(ellipse(c, d, a, e * e));
  for (const bool exchanged : {false, true}) {
    const IntersectResult result = exchanged ? solved(ground(), x) : solved(x, ground());
    REQUIRE(result.status == Status::complete);
    const Numbers numbers = numbers_of(result.graph);
    CHECK(numbers.closed == 1);
    CHECK(numbers.open == 0);
    CHECK(numbers.turning[exchanged ? 2 : 0] == 2);
    CHECK(numbers.turning[exchanged ? 3 : 1] == 2);
    // The turning points of u are (c ± e, d), those of v (c, d ± e / sqrt(a)).
    const std::size_t first = exchanged ? 2 : 0;
    for (const Node& node : result.graph.nodes) {
      const RationalInterval &u = node.box[first], &v = node.box[first + 1];
      for (const Parameter p : node.wrt) {
        if (index(p) == first)
          CHECK(((u.lower <= c - e && c - e <= u.upper) || (u.lower <= c + e && c + e <= u.upper)));
        if (index(p) == first || index(p) == first + 1)
          CHECK((u.lower <= c + e && u.upper >= c - e && v.lower <= d + 2 * e && v.upper >= d - 2 * e));
      }
    }
  }
  const IntersectResult apart = solved(make(ellipse(c, d, a, -e * e)), ground());
  CHECK(apart.status == Status::complete);
  CHECK(apart.graph.nodes.empty());
}

}  // namespace

TEST_CASE("magnified box: around a place, inside of the squares", "[filter]") {
  const ParameterBox box = filter::box_to_magnify({0, -0.5, 0.5, 0x1.8p-16});
  CHECK(box[0].lower == Rational(1, 2) - power_of_two(-13));
  CHECK(box[0].upper == Rational(1, 2) + power_of_two(-13));
  CHECK(box[1].lower == 0);
  CHECK(box[1].upper == power_of_two(-13));
  CHECK(box[2].lower == 1 - power_of_two(-13));
  CHECK(box[2].upper == 1);
  CHECK(box[3].width() == power_of_two(-12));
  const ParameterBox wide = filter::widened(box);
  CHECK(wide[0].lower == Rational(1, 2) - power_of_two(-8));
  CHECK(wide[0].upper == Rational(1, 2) + power_of_two(-8));
  CHECK(wide[1].lower == 0);
  CHECK(wide[3].width() == power_of_two(-7));
}

TEST_CASE("magnified box: loops and gaps of bicubic pairs", "[filter]") {
  for (const int bits : {9, 16, 21, 30, 60}) check_loop(bicubic_graph, bits);
}

TEST_CASE("magnified box: loops of all sizes about those that doubles trace", "[filter]") {
  std::size_t loops = 0;
  for (int half_bits = 16; half_bits <= 42; ++half_bits) {
    INFO("the square of the radius is 2^-" << half_bits);
    random_nets::Generator generator(static_cast<std::uint64_t>(half_bits));
    const auto number = [&](long low, std::uint64_t count) {
      return Rational(low + static_cast<long>(generator() % count));
    };
    const Terms level =
        ellipse(number(20, 60) / 101, number(20, 60) / 103, Rational(3, 4), power_of_two(-half_bits));
    // The same bicubic function on both, so that neither has an inverse, in other parameters on x.
    Terms bent = {{{3, 3}, Rational(1, 7)}};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) bent[{i, j}] = number(-3, 7) / 16;
    const RationalPatch y = power_patch({Terms{{{1, 0}, 1}}, Terms{{{0, 1}, 1}}, bent}, 3);
    const RationalPatch x = power_patch({Terms{{{1, 0}, 1}}, Terms{{{0, 1}, 1}}, level + bent}, 3);
    const IntersectResult result =
        solved(x.restricted_to(Rational(1, 10), Rational(8, 9), Rational(1, 7), Rational(9, 10)), y);
    REQUIRE(result.status == Status::complete);
    loops += static_cast<std::size_t>(numbers_of(result.graph).closed);
    CHECK(numbers_of(result.graph).turning[0] == 2);
  }
  CHECK(loops == 27);
}

TEST_CASE("magnified box: loops and gaps of weighted pairs", "[filter]") {
  for (const int bits : {12, 21, 30, 60}) check_loop(weighted_graph, bits);
}

TEST_CASE("magnified box: pieces with a solution on a side are not decided", "[filter]") {
  // The closed curve is larger than the box, and passes through its middle.
  const RationalPatch x = bicubic_graph(ellipse(Rational(1, 4), Rational(1, 2), 1, Rational(1, 16)));
  const filter::SolvePieces solve = [](const RationalPatch& a, const RationalPatch& b, const Run&) {
    return intersect(a, b);
  };
  const auto box = [](const Rational& u, const Rational& v) {
    const auto around = [](const Rational& t) {
      return RationalInterval{t - power_of_two(-12), t + power_of_two(-12)};
    };
    return ParameterBox{around(u), around(v), around((1 + u) / 3), around((1 + v) / 3)};
  };
  const RationalPatch y = testing::plane({-1, -1, 0}, {3, 0, 0}, {0, 3, 0});
  const auto crossed = filter::magnified(x, y, box(Rational(1, 2), Rational(1, 2)), 1, Run{}, solve);
  REQUIRE(crossed);
  CHECK(crossed->meets_side);
  const auto nothing = filter::magnified(x, y, box(Rational(3, 4), Rational(1, 2)), 1, Run{}, solve);
  REQUIRE(nothing);
  CHECK_FALSE(nothing->meets_side);
  CHECK(nothing->inside.graph.nodes.empty());
}

TEST_CASE("magnified box: a double point that may be in a box is not counted again", "[filter]") {
  const Rational half(1, 2);
  const auto x = filter::elevated<filter::Bicubic>(bicubic_graph(ellipse(half, half, 1, 0)));
  const auto y = filter::elevated<filter::Bicubic>(testing::plane({-1, -1, 0}, {3, 0, 0}, {0, 3, 0}));
  const auto solve = [&](std::vector<ParameterBox> boxes) {
    return filter::filtered_intersection<filter::Bicubic>(x, y, Run{}, false, std::move(boxes)).result;
  };
  const auto alone = solve({});
  REQUIRE(alone);
  CHECK(alone->graph.isolated_points.size() == 1);
  // The point is a corner of the box.
  const RationalInterval above = {half, Rational(3, 4)};
  CHECK_FALSE(solve({ParameterBox{above, above, above, above}}));
}

}  // namespace exsect::magnified_box_test
