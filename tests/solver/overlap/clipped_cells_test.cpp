// Pieces of a surface that meets itself: a sheet with a pinch point, whose curve has a closed form; sheets
// near it, whose curves are compared with the exact oracle on parameter lines and with those of the whole
// surface.
#include "overlap/clipped_cells.h"

#include <exsect/solver/intersect_rational.h>

#include <cmath>

#include "support/catch.h"
#include "support/exact_oracle.h"
#include "support/graph_isomorphism.h"
#include "support/power_nets.h"
#include "support/random_nets.h"
#include "support/self_orders.h"

namespace exsect::clipped_cells_test {
namespace {

using random_nets::Generator;
using Ends = std::array<Rational, 4>;

RationalPatch piece(const RationalPatch& x, const Ends& ends) {
  return x.restricted_to(ends[0], ends[1], ends[2], ends[3]);
}

/// (t^3 - a t, t^2, v) with t = 2 u - 1 and a = v - 2/5: the same point at t and -t if t^2 = a. The pinch
/// point is u = 1/2, v = 2/5.
RationalPatch pinched_sheet() {
  const Rational fifth(1, 5);
  return testing::power_patch(
      {testing::Terms{{{3, 0}, 8},
                      {{2, 0}, -12},
                      {{1, 0}, 6 + 4 * fifth},
                      {{1, 1}, -2},
                      {{0, 1}, 1},
                      {{0, 0}, -1 - 2 * fifth}},
       testing::Terms{{{2, 0}, 4}, {{1, 0}, -4}, {{0, 0}, 1}}, testing::Terms{{{0, 1}, 1}}},
      3);
}

/// Every control point moved by less than 1/8, and multiplied by a weight if `weighted`.
RationalPatch near_pinched_sheet(Generator& generator, bool weighted) {
  random_nets::Net net;
  const RationalPatch sheet = pinched_sheet();
  for (int i = 0; i <= 3; ++i) {
    net.emplace_back();
    for (int j = 0; j <= 3; ++j) {
      const HomogeneousPoint& p = sheet.homogeneous(i, j);
      const auto moved = [&](std::size_t k) -> Rational {
        return p[k] + Rational(random_pairs::integer(generator, -8, 8), 65);
      };
      net.back().push_back({moved(0), moved(1), moved(2)});
    }
  }
  return weighted ? random_nets::weighted(generator, net) : RationalPatch(net);
}

/// How often polylines of the arcs cross parameter j = value, of the points for which `counts`.
template <class Counts>
std::size_t crossings(const IntersectionGraph& graph, std::size_t j, double value, const Counts& counts) {
  std::size_t n = 0;
  for (const Arc& arc : graph.arcs)
    for (std::size_t k = 1; k < arc.polyline.size(); ++k) {
      const auto &a = arc.polyline[k - 1].parameters, &b = arc.polyline[k].parameters;
      if ((a[j] < value) != (b[j] < value) && counts(a)) ++n;
    }
  return n;
}

const auto all = [](const std::array<double, 4>&) { return true; };

/// In both orders of the pairs of the surface as many crossings with lines as there are in the pieces.
void check_with_whole(const RationalPatch& x, const std::array<Ends, 2>& ends,
                      const IntersectionGraph& graph) {
  const IntersectResult whole = self_intersect(x);
  REQUIRE(whole.status == Status::complete);
  const IntersectionGraph both = testing::in_both_orders(whole.graph);
  const auto within = [&](const std::array<double, 4>& at) {
    for (std::size_t j = 0; j < 4; ++j)
      if (at[j] < to_double(ends[j / 2][j % 2 * 2]) || at[j] > to_double(ends[j / 2][j % 2 * 2 + 1]))
        return false;
    return true;
  };
  for (std::size_t j = 0; j < 4; ++j)
    for (const Rational& part : {Rational(23, 101), Rational(48, 97), Rational(67, 103)}) {
      const Rational &lower = ends[j / 2][j % 2 * 2], &upper = ends[j / 2][j % 2 * 2 + 1];
      INFO("parameter " << j << " at " << part);
      CHECK(crossings(graph, j, to_double(part), all) ==
            crossings(both, j, to_double(lower + part * (upper - lower)), within));
    }
}

/// On lines of one of the second two pieces below that the other one does not reach: exactly, by other means.
int check_with_oracle(const RationalPatch& x, const RationalPatch& y, const IntersectionGraph& graph,
                      std::size_t j) {
  int points = 0;
  for (const Rational& value : {Rational(31, 101), Rational(44, 97), Rational(62, 103)}) {
    const Rational at = j < 2 ? value : Rational(1 - value);
    const exact_oracle::LinePoints line = exact_oracle::line_points(x, y, j, at);
    if (!line.conclusive()) continue;
    INFO("parameter " << j << " at " << at);
    CHECK(crossings(graph, j, to_double(at), all) == line.points.size());
    points += static_cast<int>(line.points.size());
  }
  return points;
}

std::size_t count(const IntersectionGraph& graph, NodeKind kind) {
  return static_cast<std::size_t>(std::ranges::count_if(
      graph.nodes, [&](const Node& node) { return std::ranges::count(node.kinds, kind) > 0; }));
}

}  // namespace

TEST_CASE("clipped cells: the sides of both squares in the hull") {
  // y(r,s) = x(3/2 - s, r/2): [1/2,3/2] x [0,1/2].
  const PiecesInHull pieces({{AffineMap{Rational(3, 2), -1}, AffineMap{0, Rational(1, 2)}}, true});
  CHECK(pieces.around[0](1) == Rational(3, 2));
  CHECK(pieces.around[1](1) == 1);
  const ParameterLines sides = pieces.sides();
  CHECK(sides[0] == std::vector<Rational>{Rational(2, 3), Rational(1, 3)});
  CHECK(sides[1] == std::vector<Rational>{Rational(1, 2)});
  const ParameterRectangle left{{0, Rational(1, 3)}, {0, 1}}, right{{Rational(1, 3), 1}, {0, Rational(1, 2)}};
  CHECK(pieces.contain({left, right}));
  CHECK_FALSE(pieces.contain({right, left}));
}

TEST_CASE("clipped cells: a pinch point inside of the overlap") {
  const RationalPatch sheet = pinched_sheet();
  const RationalPatch x = piece(sheet, {0, Rational(3, 5), 0, Rational(19, 20)});
  const RationalPatch y = piece(sheet, {Rational(1, 3), 1, Rational(1, 20), 1});
  const IntersectResult result = intersect(x, y);
  REQUIRE(result.status == Status::complete);
  const IntersectionGraph& graph = result.graph;
  REQUIRE(graph.overlaps.size() == 1);
  CHECK(graph.isolated_points.empty());
  REQUIRE(count(graph, NodeKind::cusp) == 1);
  // With t < 0 on x the curve goes on to v = 19/20, with t > 0 as far as t = 1/5.
  const auto cusp = std::ranges::find_if(
      graph.nodes, [](const Node& node) { return std::ranges::count(node.kinds, NodeKind::cusp) > 0; });
  CHECK(std::fabs(cusp->approx[0] - 5.0 / 6) < 1e-12);
  CHECK(std::fabs(cusp->approx[2] - 0.25) < 1e-12);
  CHECK(std::ranges::count(cusp->kinds, NodeKind::end_of_overlap) == 1);
  int ends = 0;
  for (const Node& node : graph.nodes) {
    const auto is_end = [&](const Arc& arc) { return arc.from == node.id || arc.to == node.id; };
    if (node.on.size() != 1 || std::ranges::none_of(graph.arcs, is_end)) continue;
    ++ends;
    const bool is_long = node.on[0].parameter == Parameter::v;
    CHECK((is_long || node.on[0].parameter == Parameter::u));
    CHECK(node.on[0].value == 1);
    const double t = is_long ? -std::sqrt(0.55) : 0.2, v = 0.4 + t * t;
    const std::array<double, 4> expected = {(1 + t) / 1.2, v / 0.95, ((1 - t) / 2 - 1.0 / 3) * 1.5,
                                            (v - 0.05) / 0.95};
    for (std::size_t j = 0; j < 4; ++j) CHECK(std::fabs(node.approx[j] - expected[j]) < 1e-12);
  }
  CHECK(ends == 2);

  CHECK(difference(graph, intersect(y, x).graph, {{2, 3, 0, 1}, {}}) == "");
  CHECK(difference(graph, intersect(x, y.transposed()).graph, {{0, 1, 3, 2}, {}}) == "");
  const Rational k(2, 3);
  CHECK(difference(graph, intersect(x, piece(y, {1, 0, 0, 1}).transposed()).graph,
                   {{0, 1, 3, 2}, {false, false, true, false}}) == "");
  Generator generator(61);
  const auto map = random_nets::projective_map(generator);
  CHECK(difference(graph, intersect(random_nets::image(x, map), random_nets::image(y, map)).graph, {}) == "");
  const random_nets::ProjectiveMap far = {HomogeneousPoint{Rational(127, 5), 0, 0, 100000000},
                                          HomogeneousPoint{0, Rational(127, 5), 0, 100000000},
                                          HomogeneousPoint{0, 0, Rational(127, 5), 100000000},
                                          HomogeneousPoint{0, 0, 0, 1}};
  CHECK(difference(graph, intersect(random_nets::image(x, far), random_nets::image(y, far)).graph, {}) == "");
  // In other parameters of the second patch, the same arcs.
  const IntersectResult changed = intersect(x, random_nets::reparametrised(y, k));
  CHECK(changed.status == Status::complete);
  CHECK(changed.graph.arcs.size() == graph.arcs.size());
  CHECK(count(changed.graph, NodeKind::cusp) == 1);
}

TEST_CASE("clipped cells: turning points in the other order are no nodes, and which are asked for") {
  const RationalPatch sheet = pinched_sheet();
  const RationalPatch x = piece(sheet, {0, Rational(9, 10), 0, 1});
  for (const bool exchanged : {false, true}) {
    const RationalPatch y = piece(sheet, {Rational(1, 10), 1, 0, Rational(9, 10)});
    IntersectOptions options;
    options.turning = {};
    const IntersectResult result = intersect(x, exchanged ? y.transposed() : y, options);
    CHECK(result.status == Status::complete);
    CHECK(result.graph.arcs.size() == 2);  // from the pinch point, in both orders
    CHECK(result.graph.components.size() == 1);
  }
}

TEST_CASE("clipped cells: pieces of sheets near the pinched one") {
  const std::vector<std::array<Ends, 2>> pieces = {
      {Ends{0, Rational(9, 10), 0, 1}, Ends{Rational(1, 10), 1, 0, Rational(7, 8)}},
      {Ends{0, Rational(3, 5), 0, 1}, Ends{Rational(2, 5), 1, Rational(1, 4), 1}}};
  int points = 0;
  for (const std::uint64_t seed : {71U, 72U, 73U, 74U}) {
    INFO("seed " << seed);
    Generator generator(seed);
    const RationalPatch sheet = near_pinched_sheet(generator, seed % 2 == 0);
    for (const std::array<Ends, 2>& ends : pieces) {
      const RationalPatch x = piece(sheet, ends[0]), y = piece(sheet, ends[1]);
      const IntersectResult result = intersect(x, y);
      CHECK(result.status == Status::complete);
      CHECK(result.graph.overlaps.size() == 1);
      check_with_whole(sheet, ends, result.graph);
      for (const std::size_t j : {0U, 2U})
        if (ends == pieces.back()) points += check_with_oracle(x, y, result.graph, j);
      CHECK(difference(result.graph, intersect(y, x).graph, {{2, 3, 0, 1}, {}}) == "");
    }
  }
  CHECK(points > 12);
}

}  // namespace exsect::clipped_cells_test
