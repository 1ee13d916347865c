#include "self/glued_fold.h"

#include <algorithm>
#include <random>
#include <vector>

#include "answer/parameter_box.h"
#include "self/boundary.h"
#include "support/catch.h"
#include "support/self_checks.h"

namespace exsect::glued_fold_test {
using exsect::testing::checked;
using exsect::testing::degrees;

namespace {

/// x(1, c + h) = x(0, c + k h), the coefficients of 1 and u^2 given.
BezierPatch strip(const std::array<Point, 3>& first, const std::array<Point, 3>& last, const Rational& c,
                  const Rational& k) {
  ControlNet d{};  // of u^i (v - c)^j
  Rational power = 1;
  for (std::size_t j = 0; j < 3; ++j, power *= k) {
    d[0][j] = first[j];
    d[1][j] = power * first[j] - first[j] - last[j];
    d[2][j] = last[j];
  }
  return BezierPatch::from_power_basis(d).restricted_to(0, 1, -c, 1 - c);
}

BezierPatch random_strip(std::mt19937& generator, const Rational& c, const Rational& k) {
  std::uniform_int_distribution<int> coefficient(-3, 3);
  std::array<std::array<Point, 3>, 2> rows;
  for (auto& row : rows)
    for (Point& p : row) p = {coefficient(generator), coefficient(generator), coefficient(generator)};
  return strip(rows[0], rows[1], c, k);
}

/// (4 u (1 - u), h (1 - 2 u), 8 u (1 - u) h), h = v - 1/2: x(1,v) = x(0,1 - v).
BezierPatch moebius_band() {
  return strip({{{0, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, {{{-4, 0, 0}, {0, 0, -8}, {0, 0, 0}}}, Rational(1, 2),
               -1);
}

std::size_t arcs_between_sides(const IntersectionGraph& graph, Parameter first) {
  const auto second = static_cast<Parameter>(index(first) + 2);
  return static_cast<std::size_t>(std::ranges::count_if(graph.arcs, [&](const Arc& arc) {
    return std::ranges::all_of(arc.polyline, [&](const PolylineVertex& vertex) {
      const double u = vertex.parameters[index(first)], r = vertex.parameters[index(second)];
      return (u == 0 && r == 1) || (u == 1 && r == 0);
    });
  }));
}

}  // namespace

TEST_CASE("glued folds: the difference is a combination of the three factors") {
  std::mt19937 generator(3);
  std::uniform_int_distribution<int> part(0, 12);
  for (const auto& [c, k] : std::vector<std::array<Rational, 2>>{
           {Rational(1, 2), -1}, {1, Rational(1, 2)}, {Rational(1, 3), Rational(-2, 5)}, {0, 3}}) {
    const BezierPatch x = random_strip(generator, c, k);
    const std::vector<GluedFold> folds = glued_folds(x);
    REQUIRE(folds.size() == 1);
    CHECK(folds[0].constant == c);
    CHECK(folds[0].ratio == k);
    CHECK(glued_folds(x.exchanged()).at(0).exchanged);
    std::array<std::array<Rational, 3>, 9> d;
    for (std::size_t i = 0; i < 9; ++i) d[i] = folds[0].d[i / 3][i % 3];
    for (int i = 0; i < 20; ++i) {
      const Rational a(part(generator), 12), b(part(generator), 12);
      const Rational v1(part(generator), 12), v2(part(generator), 12);
      const auto m = glued_fold_factors<Rational>(d, k, a, b, v1 - c, v2 - c);
      const Rational along = v1 - c - k * (v2 - c);
      const Point gap = x(a, v1) - x(1 - b, v2);
      for (std::size_t j = 0; j < 3; ++j)
        CHECK(gap[j] == (a - b) * m[0][j] + along * m[1][j] + b * (v2 - c) * m[2][j]);
    }
  }
}

TEST_CASE("glued folds: none if no side or all lines close, or the sides turn differently") {
  std::mt19937 generator(4);
  CHECK(glued_folds(exsect::testing::random_patch(generator, 3)).empty());
  // u (1 - u) in all coordinates but one; x(1,v) = x(0,v^2).
  CHECK(glued_folds(strip({{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {{{1, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, 0, 1))
            .empty());
  ControlNet c{};
  c[0][1] = {0, 0, 1};
  c[1][0] = {1, 0, 0};
  c[2][0] = {-1, 0, 0};
  c[1][1] = {0, 1, -1};
  c[1][2] = {0, 0, 1};
  c[2][1] = {0, -1, 0};
  CHECK(glued_folds(BezierPatch::from_power_basis(c)).empty());
}

TEST_CASE("glued folds: stars hold no other pairs") {
  std::mt19937 generator(5);
  for (int i = 0; i < 6; ++i) {
    const BezierPatch x =
        random_strip(generator, Rational(2, 5), i % 2 == 0 ? Rational(-1, 2) : Rational(1, 3));
    CAPTURE(i);
    const SelfBoundary boundary = self_boundary(x, {});
    const SelfStarProblem problem = {x, boundary.points, {}, {}, 1e-3, {}};
    const auto star = glued_fold_star(problem, glued_folds(x).at(0), power_of_two(-20));
    REQUIRE(star);
    CHECK(star->star.ports.size() == 3);
    CHECK(lies_in(star->star.box, star->surroundings));
    const auto in_surroundings = [&](std::size_t parameter, const Rational& value) {
      return std::ranges::count_if(exsect::testing::self_fibre(x, parameter, value), [&](const auto& point) {
        return lies_in(point.box(), star->surroundings);
      });
    };
    const Rational width = star->surroundings[0].width();
    for (const Rational& at : {Rational(1, 7), Rational(5, 6)}) {
      CHECK(in_surroundings(0, at * width) == 1);
      CHECK(in_surroundings(1, Rational(2, 5) + at * star->star.box[1].width() / 2) == 1);
    }
  }
}

TEST_CASE("a Moebius band") {
  const IntersectionGraph graph = checked(moebius_band());
  // The band is symmetrical about v = 1/2, along which it is folded.
  CHECK(graph.arcs.size() == 3);
  CHECK(graph.components.size() == 1);
  CHECK(degrees(graph, NodeKind::crossing) == std::vector{3});
  CHECK(degrees(graph, NodeKind::cusp) == std::vector{1});
  CHECK(arcs_between_sides(graph, Parameter::u) == 2);
}

TEST_CASE("strips with glued opposite sides") {
  const auto [c, k, boundary] = GENERATE(table<Rational, Rational, std::size_t>({
      {Rational(1, 2), Rational(1, 2), 2},   // the side u = 1 on the middle half of u = 0
      {Rational(1, 2), Rational(-1, 2), 2},  // reversed
      {Rational(1, 3), Rational(-1), 2},     // on two thirds of it, reversed
      {Rational(1, 3), Rational(2), 2},
      {Rational(1), Rational(1, 2), 1},  // folded along the side v = 1
      {Rational(0), Rational(3, 2), 1},
  }));
  CAPTURE(c, k);
  const unsigned seed = 4;
  std::mt19937 generator(seed);
  const BezierPatch x = random_strip(generator, c, k);
  for (const BezierPatch& patch : {x, x.restricted_to(1, 0, 1, 0)}) {
    const IntersectionGraph graph = checked(patch);
    CHECK(arcs_between_sides(graph, Parameter::u) >= boundary);
    const auto crossings = degrees(graph, NodeKind::crossing);
    CHECK(std::ranges::count(crossings, boundary == 2 ? 3 : 2) >= 1);
  }
}

}  // namespace exsect::glued_fold_test
