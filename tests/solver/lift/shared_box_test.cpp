// One surface in two boxes: what they share, against the parameters that the boxes are made of.
#include "lift/shared_box.h"

#include <exsect/geometry/surface_box.h>
#include <exsect/solver/intersect_equations.h>

#include <algorithm>
#include <random>

#include "solver/lift/shared_parts.h"
#include "support/catch.h"

namespace exsect::shared_box_test {
namespace {

using S = ImplicitSurface;
using shared_parts::shared;
using shared_parts::Shared;

const std::array<Point, 8> around = {
    {{1, 0, 0}, {1, 1, 0}, {0, 2, 0}, {-1, 1, 0}, {-3, 0, 0}, {-1, -1, 0}, {0, -1, 0}, {2, -2, 0}}};
const Point up = {0, 0, 1};

/// Numbers of directions, counter-clockwise, and heights; or numbers of directions about a tube.
struct Cell {
  std::optional<std::array<int, 2>> sector = {};
  std::optional<std::array<int, 2>> height = {};
  std::optional<std::array<int, 2>> tube = {};
};

S in(const S& whole, const Cell& cell) {
  SurfaceBox box;
  if (whole.kind() == SurfaceKind::sphere) box.axis = up;
  const auto direction = [](int k) { return around[static_cast<std::size_t>(k % 8)]; };
  if (cell.sector) box.sector = AxisSector{direction((*cell.sector)[0]), direction((*cell.sector)[1])};
  if (cell.height) box.height = HeightRange{(*cell.height)[0], (*cell.height)[1]};
  const auto of_tube = [&](int k) { return std::array{direction(k)[0], direction(k)[1]}; };
  if (cell.tube) box.tube = TubeSector{of_tube((*cell.tube)[0]), of_tube((*cell.tube)[1])};
  return boxed(whole, box);
}

const S pipe = S::cylinder({0, 0, 0}, up, 1);
const S ball = S::sphere({0, 0, 0}, 3);
const S ring = S::torus({0, 0, 0}, up, 3, 1);
const S funnel = S::cone({0, 0, 0}, up, 1);

}  // namespace

TEST_CASE("shared box: faces of a cylinder beside, over and at a corner of each other") {
  const S face = in(pipe, {{{0, 2}}, {{0, 1}}});
  CHECK(shared(face, in(pipe, {{{1, 3}}, {{0, 2}}})) == Shared{true, 0, 0});
  CHECK(shared(face, pipe) == Shared{true, 0, 0});
  CHECK(shared(face, in(pipe, {{{2, 4}}, {{0, 1}}})) == Shared{false, 1, 0});  // a common ruling
  CHECK(shared(face, in(pipe, {{{0, 2}}, {{1, 2}}})) == Shared{false, 1, 0});  // a common arc
  CHECK(shared(face, in(pipe, {{{2, 4}}, {{1, 2}}})) == Shared{false, 0, 1});  // a corner
  CHECK(shared(face, in(pipe, {{{3, 5}}, {{0, 1}}})) == Shared{false, 0, 0});
  CHECK(shared(face, in(pipe, {{{0, 2}}, {{2, 3}}})) == Shared{false, 0, 0});
  const S half = in(pipe, {{{0, 4}}, {{0, 1}}});
  CHECK(shared(half, in(pipe, {{{4, 8}}, {{0, 1}}})) == Shared{false, 2, 0});  // two opposite rulings
  CHECK(shared(half, in(pipe, {{{3, 8}}, {{0, 1}}})) == Shared{true, 1, 0});   // and one at the other end
  CHECK(shared(in(pipe, {{{0, 3}}, {{0, 1}}}), in(pipe, {{{3, 8}}, {{0, 1}}})) == Shared{false, 2, 0});
  const SurfaceIntersection rim = intersect(in(pipe, {{}, {{0, 1}}}), in(pipe, {{}, {{1, 2}}}));
  REQUIRE(rim.curves.size() == 1);
  CHECK(rim.curves[0].kind == SpaceCurveKind::circle);
  CHECK(rim.curves[0].point == Point{0, 0, 1});
}

TEST_CASE("shared box: the same surface from other data") {
  const S turned = S::cylinder({0, 0, 7}, {0, 0, -2}, 1);  // heights 2 to 3 are 3 to 1 over the first one
  SurfaceBox box;
  box.height = HeightRange{2, 3};
  CHECK(shared(in(pipe, {{}, {{0, 1}}}), boxed(turned, box)) == Shared{false, 1, 0});
  CHECK(shared(in(pipe, {{}, {{0, 2}}}), boxed(turned, box)) == Shared{true, 0, 0});
  box.height.reset();
  box.sector = AxisSector{around[2], around[0]};  // clockwise about the first axis
  CHECK(shared(in(pipe, {{{0, 2}}}), boxed(turned, box)) == Shared{true, 0, 0});
  const S equation = S::polynomial(SpacePolynomial({{{2, 0, 0}, 3}, {{0, 2, 0}, 3}, {{0, 0, 0}, -3}}));
  CHECK(shared(in(pipe, {{{0, 2}}, {{0, 1}}}), equation) == Shared{true, 0, 0});
  CHECK(shared(pipe, equation) == Shared{true, 0, 0});
}

TEST_CASE("shared box: poles and apexes") {
  const auto slice = [](const S& whole, int from, int to) { return in(whole, {{{from, to}}, {{-3, 3}}}); };
  CHECK(shared(slice(ball, 0, 2), slice(ball, 1, 3)) == Shared{true, 0, 0});
  CHECK(shared(slice(ball, 0, 2), slice(ball, 4, 6)) == Shared{false, 0, 2});  // both poles
  CHECK(shared(in(ball, {{{0, 2}}, {{0, 3}}}), in(ball, {{{4, 6}}, {{-1, 5}}})) == Shared{false, 0, 1});
  CHECK(shared(in(ball, {{{0, 2}}, {{0, 2}}}), in(ball, {{{4, 6}}, {{-1, 5}}})) == Shared{false, 0, 0});
  CHECK(shared(in(ball, {{}, {{3, 4}}}), in(ball, {{}, {{2, 4}}})) == Shared{false, 0, 1});  // the pole alone
  CHECK(shared(in(ball, {{}, {{4, 5}}}), ball) == Shared{false, 0, 0});
  // Two meridians from pole to pole, with an angle; two rulings from the apex.
  CHECK(shared(slice(ball, 0, 3), slice(ball, 3, 8)) == Shared{false, 2, 0});
  CHECK(intersect(slice(ball, 0, 3), slice(ball, 3, 8)).count(SpaceNodeKind::singular) == 2);
  CHECK(shared(in(ball, {{{0, 3}}, {{0, 2}}}), in(ball, {{{3, 8}}, {{1, 4}}})) == Shared{false, 2, 0});
  CHECK(shared(in(funnel, {{{0, 3}}, {{0, 3}}}), in(funnel, {{{3, 8}}, {{0, 2}}})) == Shared{false, 2, 0});
  CHECK(shared(in(funnel, {{{0, 2}}, {{0, 3}}}), in(funnel, {{{4, 6}}, {{0, 3}}})) == Shared{false, 0, 1});
  CHECK(shared(in(funnel, {{{0, 2}}, {{1, 3}}}), in(funnel, {{{2, 6}}, {{1, 4}}})) == Shared{false, 1, 0});
}

TEST_CASE("shared box: parts of a torus") {
  const auto part = [](int from, int to, int low, int high) {
    return in(ring, {{{from, to}}, {}, {{low, high}}});
  };
  CHECK(shared(part(0, 2, 0, 2), part(1, 3, 1, 3)) == Shared{true, 0, 0});
  CHECK(shared(part(0, 2, 0, 2), part(2, 3, 1, 3)) == Shared{false, 1, 0});
  CHECK(shared(part(0, 2, 0, 2), part(1, 3, 2, 3)) == Shared{false, 1, 0});
  CHECK(shared(part(0, 2, 0, 2), part(2, 3, 2, 3)) == Shared{false, 0, 1});
  CHECK(shared(part(0, 2, 0, 2), part(3, 4, 0, 3)) == Shared{false, 0, 0});
  CHECK(shared(part(0, 2, 0, 4), part(0, 2, 4, 8)) == Shared{false, 2, 0});
  CHECK(shared(in(ring, {{}, {{0, 1}}}), in(ring, {{}, {{-1, 0}}})) == Shared{false, 2, 0});
  CHECK(shared(part(0, 4, 0, 4), part(3, 8, 4, 8)) ==
        Shared{false, 2, 2});  // arcs of two circles, and points
  CHECK(shared(part(0, 4, 0, 5), part(3, 8, 4, 8)) == Shared{true, 2, 1});
}

TEST_CASE("shared box: parallelograms of one plane") {
  const auto tile = [](const Point& at, const Point& a, const Point& b) {
    SurfaceBox box;
    box.sides = std::array<Point, 2>{a, b};
    return boxed(S::plane(at, up), box);
  };
  const S square = tile({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  CHECK(shared(square, tile({Rational(1, 2), 0, 0}, {1, 1, 0}, {0, 1, 0})) == Shared{true, 0, 0});
  CHECK(shared(square, tile({1, Rational(1, 2), 0}, {1, 0, 0}, {0, 1, 0})) == Shared{false, 1, 0});
  CHECK(shared(square, tile({1, 1, 0}, {1, 0, 0}, {0, 1, 0})) == Shared{false, 0, 1});
  CHECK(shared(square, tile({2, 1, 0}, {1, 1, 0}, {1, -1, 0})) == Shared{false, 0, 0});
  CHECK(shared(square, tile({1, Rational(1, 2), 0}, {1, 1, 0}, {1, -1, 0})) == Shared{false, 0, 1});
  CHECK(shared(square, S::plane({0, 0, 0}, {0, 0, -3})) == Shared{true, 0, 0});
}

TEST_CASE("shared box: random faces of a cylinder, cell by cell") {
  std::mt19937 generator(5);
  const auto pick = [&](int from, int to) { return std::uniform_int_distribution<int>(from, to)(generator); };
  for (int k = 0; k < 60; ++k) {
    std::array<Cell, 2> cells;
    for (Cell& cell : cells) {
      const int from = pick(0, 7), low = pick(0, 2);
      cell = {{{from, from + pick(1, 7)}}, {{low, low + pick(1, 2)}}, {}};
    }
    // Directions and heights are even numbers, what is between them odd ones.
    const auto has = [](const std::array<int, 2>& range, int number, int period) {
      for (const int n : {number, number + period})
        if (2 * range[0] <= n && n <= 2 * range[1]) return true;
      return false;
    };
    bool is_same = false, is_any = false;
    for (int turn = 0; turn < 16; ++turn)
      for (int height = 0; height <= 8; ++height) {
        const bool both = std::ranges::all_of(cells, [&](const Cell& cell) {
          return has(*cell.sector, turn, 16) && has(*cell.height, height, 1000);
        });
        is_any = is_any || both;
        is_same = is_same || (both && turn % 2 == 1 && height % 2 == 1);
      }
    INFO(k << " of seed 5");
    const Shared found = shared(in(pipe, cells[0]), in(pipe, cells[1]));
    CHECK(found.is_same == is_same);
    CHECK((found.is_same || found.curves > 0 || found.points > 0) == is_any);
  }
}

TEST_CASE("shared box: random parts of a torus, by turns, turns about the tube and heights") {
  std::mt19937 generator(6);
  const auto pick = [&](int from, int to) { return std::uniform_int_distribution<int>(from, to)(generator); };
  // The tube runs through heights 0, 1, 0, -1; positions about it are even in directions, odd between them.
  const std::array<int, 16> height = {0, 1, 1, 1, 2, 1, 1, 1, 0, -1, -1, -1, -2, -1, -1, -1};
  const auto is_in = [&](const Cell& cell, int turn, int about) {
    const auto has = [](const std::optional<std::array<int, 2>>& range, int at) {
      return !range || (2 * (*range)[0] <= at && at <= 2 * (*range)[1]) || at + 16 <= 2 * (*range)[1];
    };
    const int h = height[static_cast<std::size_t>(about)];
    return has(cell.sector, turn) && has(cell.tube, about) &&
           (!cell.height || (2 * (*cell.height)[0] <= h && h <= 2 * (*cell.height)[1]));
  };
  for (int k = 0; k < 60; ++k) {
    std::array<Cell, 2> cells;
    for (Cell& cell : cells) {
      const auto arc = [&] {
        const int from = pick(0, 7);
        return std::array{from, from + pick(1, 7)};
      };
      if (pick(0, 1) == 0) cell.sector = arc();
      if (pick(0, 2) > 0) cell.tube = arc();
      if (const int low = pick(-2, 0); pick(0, 1) == 0 || !cell.tube) cell.height = {{low, low + pick(1, 2)}};
    }
    const auto both = [&](int turn, int about) {
      return is_in(cells[0], turn & 15, about & 15) && is_in(cells[1], turn & 15, about & 15);
    };
    // Whether a cell of more dimensions with this one on its rim is in both.
    const auto is_rim = [&](int turn, int about) {
      for (const int i : turn % 2 == 1 ? std::vector{0} : std::vector{-1, 0, 1})
        for (const int j : about % 2 == 1 ? std::vector{0} : std::vector{-1, 0, 1})
          if ((i != 0 || j != 0) && both(turn + i, about + j)) return true;
      return false;
    };
    bool is_same = false, has_curves = false;
    int points = 0;
    for (int turn = 0; turn < 16; ++turn)
      for (int about = 0; about < 16; ++about) {
        if (!both(turn, about)) continue;
        const int dimension = turn % 2 + about % 2;
        is_same = is_same || dimension == 2;
        has_curves = has_curves || (dimension == 1 && !is_rim(turn, about));
        points += dimension == 0 && !is_rim(turn, about) ? 1 : 0;
      }
    INFO(k << " of seed 6");
    const Shared found = shared(in(ring, cells[0]), in(ring, cells[1]));
    CHECK(found.is_same == is_same);
    CHECK((found.curves > 0) == has_curves);
    CHECK(found.points == points);
  }
}

}  // namespace exsect::shared_box_test
