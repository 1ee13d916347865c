// Patches with parameter lines that are one point, where nothing else meets.
#include "self/collapsed.h"

#include <exsect/solver/self_intersect.h>

#include <random>
#include <vector>

#include "shape/special_cusps.h"
#include "support/catch.h"
#include "support/preimages.h"

namespace exsect::collapsed_test {

namespace {

const Rational half(1, 2);

using Random = std::mt19937_64;

/// b (e0 + e1 u + e2 u^2) + b^2 (e3 + e4 u + e5 u^2), b = v - c: the line v = c is one point.
BezierPatch cone(const Rational& c, const std::array<Point, 6>& e) {
  ControlNet net{};
  for (std::size_t i = 0; i < 3; ++i) {
    net[i][1] = e[i];
    net[i][2] = e[3 + i];
  }
  return BezierPatch::from_power_basis(net).restricted_to(0, 1, -c, 1 - c);
}

const Point zero = {0, 0, 0};

/// The line v = c is the only node, also with the parameters exchanged.
void check_tip(const BezierPatch& x, const Rational& c) {
  for (const std::size_t fixed : {1, 0}) {
    const auto result = self_intersect(fixed == 1 ? x : x.exchanged());
    REQUIRE(result.status == Status::complete);
    CHECK(result.graph.arcs.empty());
    CHECK(result.graph.overlaps.empty());
    REQUIRE(result.graph.nodes.size() == 1);
    CHECK(result.graph.isolated_points == std::vector<int>{0});
    const Node& tip = result.graph.nodes.front();
    CHECK(tip.free ==
          std::vector<Parameter>{static_cast<Parameter>(1 - fixed), static_cast<Parameter>(3 - fixed)});
    for (const std::size_t j : {fixed, fixed + 2}) {
      CHECK(tip.box[j].lower == c);
      CHECK(tip.box[j].upper == c);
    }
  }
}

std::array<Point, 6> random_cone(Random& random) {
  std::array<Point, 6> e;
  for (Point& p : e)
    for (Rational& c : p) c = static_cast<int>(random() % 9) - 4;
  return e;
}

std::array<Rational, 2> random_point(Random& random) {
  return {Rational(random() % 97, 96), Rational(random() % 97, 96)};
}

}  // namespace

TEST_CASE("self_intersect: double cones") {
  const std::array<Point, 6> circle = {{{1, 0, 1}, {0, 2, 0}, {-1, 0, 0}, zero, zero, zero}};
  check_tip(cone(half, circle), half);
  check_tip(cone(Rational(1, 3), circle), Rational(1, 3));
  check_tip(cone(power_of_two(-40), circle), power_of_two(-40));
  // No coordinate depends on v alone.
  const std::array<Point, 6> bent = {
      {{1, 0, 1}, {0, 2, 0}, {-1, 0, 0}, zero, {0, 0, Rational(1, 3)}, {0, Rational(1, 4), 0}}};
  check_tip(cone(half, bent), half);
  check_tip(cone(Rational(2, 5), bent), Rational(2, 5));
}

TEST_CASE("self_intersect: an apex at which both derivatives vanish") {
  // (u v, v^2, u^2 v).
  const std::array<Point, 6> apex = {{zero, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, zero, zero}};
  check_tip(cone(0, apex), 0);
}

TEST_CASE("self_intersect: other pairs next to a tip") {
  // n.x is v^2: the side u = 0 is run through twice. The line b = 1/4 is folded.
  for (const std::array<Point, 6>& e :
       {std::array<Point, 6>{{zero, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, zero, zero}},
        std::array<Point, 6>{{{Rational(1, 4), Rational(1, 8), 1},
                              {-1, Rational(-1, 4), 0},
                              {1, 0, 0},
                              {0, -half, 0},
                              {0, 1, 0},
                              zero}}})
    CHECK(!self_intersect_collapsed(cone(half, e), {}));
  CHECK(has_folded_line(cone(0, {{{Rational(1, 4), Rational(1, 8), 1},
                                  {-1, Rational(-1, 4), 0},
                                  {1, 0, 0},
                                  {0, -half, 0},
                                  {0, 1, 0},
                                  zero}})));
}

TEST_CASE("self_intersect: random cones") {
  Random random(5);
  int proved = 0;
  IntersectOptions options;
  options.max_seconds = 2;
  for (int i = 0; i < 30; ++i) {
    CAPTURE(i);
    const Rational c(1 + i % 3, 4);
    auto e = random_cone(random);
    e[3] = Rational(1, 4) * e[3];
    e[4] = Rational(1, 4) * e[4];
    e[5] = Rational(1, 4) * e[5];
    const BezierPatch x = cone(c, e);
    if (self_intersect_collapsed(x, options)) {
      ++proved;
      for (int j = 0; j < 6; ++j) {
        const auto w = random_point(random);
        if (w[1] != c) CHECK(!preimage_apart_from(x, w, {w}, random));
      }
    }
    // One condition on e0 gives p and q one image.
    const auto p = random_point(random);
    const auto q = random_point(random);
    const Rational a = p[1] - c;
    const Rational b = q[1] - c;
    if (a == b || a == 0 || b == 0) continue;
    const auto rest = [&](const Rational& u, const Rational& h) {
      return h * (u * e[1] + u * u * e[2]) + h * h * (e[3] + u * e[4] + u * u * e[5]);
    };
    e[0] = Rational(-1) / (a - b) * (rest(p[0], a) - rest(q[0], b));
    const BezierPatch y = cone(c, e);
    REQUIRE(y(p[0], p[1]) == y(q[0], q[1]));
    CHECK(!self_intersect_collapsed(y, options));
  }
  CAPTURE(proved);
  CHECK(proved >= 8);
}

}  // namespace exsect::collapsed_test
