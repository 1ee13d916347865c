// Two pieces of one polynomial surface: the maps between their parameters, and the curves in which the
// surface meets itself, cuspidal points inside the common region included.
#include "overlap/two_pieces.h"

#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>
#include <exsect/solver/self_intersect.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/catch.h"
#include "support/graph_checks.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"

namespace exsect::two_pieces_test {
namespace {

Rational q(int a, int b) { return {a, b}; }

BezierPatch second_example() {
  return read_patches(EXSECT_EXAMPLES "/chapter9-second.json").patches.at(0).patch;
}

const Node* node_of_kind(const IntersectionGraph& graph, NodeKind kind) {
  const auto found = std::find_if(graph.nodes.begin(), graph.nodes.end(), [&](const Node& node) {
    return std::count(node.kinds.begin(), node.kinds.end(), kind) > 0;
  });
  return found == graph.nodes.end() ? nullptr : &*found;
}

const Node* node_on(const IntersectionGraph& graph, const Side& side) {
  const auto found = std::find_if(graph.nodes.begin(), graph.nodes.end(), [&](const Node& node) {
    return node.on.size() == 1 && node.on.front() == side;
  });
  return found == graph.nodes.end() ? nullptr : &*found;
}

void check_approx(const Node* node, const std::array<double, 4>& expected) {
  REQUIRE(node != nullptr);
  for (std::size_t j = 0; j < 4; ++j) CHECK(node->approx[j] == Approx(expected[j]).margin(1e-12));
}

/// Sound, in agreement with the oracle, and the same with the patches exchanged and with r and s exchanged.
void check_all_ways(const BezierPatch& x, const BezierPatch& y, const IntersectResult& result) {
  CHECK(unsound(x, y, result) == "");
  const IntersectResult swapped = intersect(y, x);
  CHECK(unsound(y, x, swapped) == "");
  const IntersectResult exchanged = intersect(x, y.exchanged());
  CHECK(unsound(x, y.exchanged(), exchanged) == "");
  CHECK(swapped.status == result.status);
  CHECK(exchanged.status == result.status);
  if (result.status != Status::complete) return;
  CHECK(compare_with_oracle(x, y, result.graph).difference == "");
  CHECK(difference(result.graph, swapped.graph, {{2, 3, 0, 1}, {}}, 1e-3) == "");
  CHECK(difference(result.graph, exchanged.graph, {{0, 1, 3, 2}, {}}, 1e-3) == "");
}

}  // namespace

TEST_CASE("two pieces: cuts of the other order on sides, in parameters that are no dyadic numbers") {
  // The line u = 0 of x is r = 1/3 of y, and folds back onto itself: its ends are one point of space.
  const auto patch = [](const std::array<Point, 9>& p) {
    return BezierPatch({{{p[0], p[1], p[2]}, {p[3], p[4], p[5]}, {p[6], p[7], p[8]}}});
  };
  const BezierPatch x = patch({{{1, -1, 0},
                                {2, 2, 0},
                                {1, -1, 0},
                                {0, 1, 2},
                                {0, 0, 2},
                                {1, 0, -2},
                                {-2, -2, 0},
                                {2, 2, -2},
                                {2, 2, 0}}});
  const BezierPatch y = patch({{{q(7, 4), q(-17, 4), -3},
                                {q(53, 8), q(77, 8), q(-15, 4)},
                                {q(-17, 4), q(-25, 2), q(45, 4)},
                                {1, q(5, 2), 3},
                                {-2, q(-11, 4), q(9, 2)},
                                {q(23, 8), q(-1, 8), -12},
                                {-2, -2, 0},
                                {4, 4, -3},
                                {1, 1, 3}}});
  const IntersectResult result = intersect(x, y);
  CHECK(result.status == Status::complete);
  CHECK(result.graph.overlaps.size() == 1);
  CHECK(result.graph.components.size() == 1);
  check_all_ways(x, y, result);
}

TEST_CASE("shifted copy: the maps are found") {
  random_pairs::Generator generator(20);
  for (int i = 0; i < 20; ++i) {
    const BezierPatch x = random_pairs::scattered(generator).x;
    const std::array<Rational, 4> ends = {q(i - 9, 7), q(11 - i, 5) + q(1, 9), q(3, i + 1), q(-i, 8) - 1};
    const BezierPatch y = x.restricted_to(ends[0], ends[1], ends[2], ends[3]);
    const auto copy = shifted_copy(x, y);
    REQUIRE(copy);
    CHECK(copy->maps[0](0) == ends[0]);
    CHECK(copy->maps[0](1) == ends[1]);
    CHECK(copy->maps[1].inverse(ends[3]) == 1);
    ControlNet net = y.net();
    net[static_cast<std::size_t>(i % 3)][1][0] += q(1, 1000);
    CHECK_FALSE(shifted_copy(x, BezierPatch(net)));
    CHECK_FALSE(shifted_copy(x, y.exchanged()));
  }
}

TEST_CASE("shifted copy: the derivative x_vv is linear in u") {
  ControlNet c = second_example().power_basis();
  c[2][2] = {0, 0, 0};
  const BezierPatch x = BezierPatch::from_power_basis(c);
  const auto copy = shifted_copy(x, x.restricted_to(q(1, 3), q(5, 3), q(3, 4), q(-1, 4)));
  REQUIRE(copy);
  CHECK(copy->maps[0](1) == q(5, 3));
  CHECK(copy->maps[1](0) == q(3, 4));
}

TEST_CASE("two pieces: the smallest rectangle around both") {
  const BezierPatch x = second_example();
  const auto around = [&](const BezierPatch& y) { return two_pieces(x, y)->around; };
  const auto both = around(x.restricted_to(q(9, 8), q(-3, 8), q(1, 4), q(7, 4)));
  CHECK(both[0].offset == q(-3, 8));
  CHECK(both[0].factor == q(3, 2));
  CHECK(both[1].offset == 0);
  CHECK(both[1].factor == q(7, 4));
  const auto apart = around(x.restricted_to(2, 3, q(1, 4), q(1, 2)));
  CHECK(apart[0](1) == 3);
  CHECK(apart[1](1) == 1);
}

TEST_CASE("two pieces: a curve of the second example ends in a cuspidal point of the overlap") {
  const BezierPatch x = second_example();
  const BezierPatch y = x.restricted_to(0, 1, q(1, 4), q(5, 4));
  const IntersectResult result = intersect(x, y);
  CHECK(result.status == Status::complete);
  CHECK(result.graph.overlaps.size() == 1);
  const Node* cusp = node_of_kind(result.graph, NodeKind::cusp);
  check_approx(cusp, {0.433004229933352, 0.371653919708524, 0.433004229933352, 0.371653919708524 - 0.25});
  CHECK(std::count(cusp->kinds.begin(), cusp->kinds.end(), NodeKind::end_of_overlap) == 1);
  // The pair at which v2 = 0, in the order in which that point is not in y's piece, and where s = 0 earlier.
  check_approx(node_on(result.graph, {Parameter::v, 0}),
               {0.431265860133535, 0, 0.435436781509311, 0.743017458321801 - 0.25});
  REQUIRE(node_on(result.graph, {Parameter::s, 0}) != nullptr);
  CHECK(node_on(result.graph, {Parameter::s, 0})->approx[1] > 0.3716539197085);
  CHECK(result.graph.components.size() == 1);
  check_all_ways(x, y, result);
}

TEST_CASE("two pieces: the charts agree with the self-intersection where the pieces are nearly all of it") {
  const BezierPatch y = read_patches(EXSECT_EXAMPLES "/chapter9-second.json").patches.at(1).patch;
  const IntersectResult self = self_intersect(y);
  const IntersectResult result = intersect(y, y.restricted_to(0, 1 + q(1, 1000000), 0, 1));
  REQUIRE(self.status == Status::complete);
  CHECK(result.status == Status::complete);
  const auto cusps = [](const IntersectionGraph& graph) {
    return std::count_if(graph.nodes.begin(), graph.nodes.end(), [](const Node& node) {
      return std::count(node.kinds.begin(), node.kinds.end(), NodeKind::cusp) > 0;
    });
  };
  CHECK(cusps(result.graph) == cusps(self.graph));
  // Of every curve both orders; those of a curve with a cuspidal point are one component.
  const auto curves = static_cast<long>(self.graph.components.size());
  CHECK(static_cast<long>(result.graph.components.size()) == 2 * curves - cusps(self.graph));
}

BezierPatch with_closed_curve() {
  const std::array<std::array<int, 3>, 9> points = {{{30, -34, -22},
                                                     {21, 14, -2},
                                                     {-45, -12, 3},
                                                     {-5, 39, 36},
                                                     {-11, 49, -30},
                                                     {14, -8, -23},
                                                     {41, -8, 41},
                                                     {-16, -26, 43},
                                                     {25, -36, -10}}};
  ControlNet net;
  for (std::size_t i = 0; i < 9; ++i) net[i / 3][i % 3] = {points[i][0], points[i][1], points[i][2]};
  return BezierPatch(net).restricted_to(q(-1, 2), q(15, 8), q(-4, 5), q(4, 3));
}

/// x_u + m x_v = 0 at (1/2,1/2), m = 1 or -1: a cuspidal point, from which the pairs of points near (1/2,1/2)
/// + (t, m t) and (1/2,1/2) - (t, m t) start.
BezierPatch with_cusp_in_the_middle(std::mt19937_64& generator, int m) {
  const auto digit = [&] { return Rational(static_cast<int>(generator() % 19) - 9, 4); };
  ControlNet c{};
  for (auto& row : c)
    for (Point& p : row) p = {digit(), digit(), digit()};
  c[1][0] = Rational(-m) * c[0][1];
  return BezierPatch::from_power_basis(c).restricted_to(q(-1, 2), q(1, 2), q(-1, 2), q(1, 2));
}

/// Two pieces of such a patch, each over [from u, to u] x [from v, to v].
struct PiecesAtCusp {
  int m;
  std::array<Rational, 4> first;
  std::array<Rational, 4> second;
};

std::array<BezierPatch, 2> pieces_of(const PiecesAtCusp& pieces, std::mt19937_64& generator) {
  const BezierPatch x = with_cusp_in_the_middle(generator, pieces.m);
  const auto piece = [&](const std::array<Rational, 4>& r) {
    return x.restricted_to(r[0], r[1], r[2], r[3]);
  };
  return {piece(pieces.first), piece(pieces.second)};
}

TEST_CASE("two pieces: a cuspidal point on sides that no curve enters") {
  std::mt19937_64 generator(5);
  const Rational half = q(1, 2);
  const std::array<Rational, 4> all = {0, 1, 0, 1};
  for (const PiecesAtCusp& pieces :
       {PiecesAtCusp{1, {half, 1, 0, half}, all}, PiecesAtCusp{1, all, {0, half, half, 1}},
        PiecesAtCusp{-1, {half, 1, half, 1}, all}, PiecesAtCusp{-1, all, {0, half, 0, half}},
        PiecesAtCusp{1, {half, 1, 0, 1}, {0, 1, half, 1}}, PiecesAtCusp{-1, {half, 1, 0, 1}, {0, 1, 0, half}},
        PiecesAtCusp{1, {half, 1, 0, 1}, {half, 1, q(1, 3), 1}}}) {
    INFO("m = " << pieces.m);
    const auto [x, y] = pieces_of(pieces, generator);
    const IntersectResult result = intersect(x, y);
    CHECK(result.status == Status::complete);
    CHECK(result.graph.overlaps.size() == 1);
  }
}

long ends_at(const std::vector<Arc>& arcs, int node) {
  const auto count = [&](int Arc::*end) { return std::ranges::count(arcs, node, end); };
  return count(&Arc::from) + count(&Arc::to);
}

long ends_on_rims(const IntersectionGraph& graph, int node) {
  long result = 0;
  for (const Overlap& overlap : graph.overlaps)
    for (const std::vector<Arc>& chain : overlap.chains) result += ends_at(chain, node);
  return result;
}

TEST_CASE("two pieces: a cuspidal point on a side, from which one order of a curve starts") {
  std::mt19937_64 generator(6);
  const Rational half = q(1, 2);
  const std::array<Rational, 4> all = {0, 1, 0, 1};
  for (const PiecesAtCusp& pieces :
       {PiecesAtCusp{1, {half, 1, q(1, 8), 1}, all}, PiecesAtCusp{1, {half, 1, half, 1}, all},
        PiecesAtCusp{-1, all, {half, 1, 0, half}}, PiecesAtCusp{-1, {half, 1, 0, 1}, {0, 1, half, 1}}}) {
    INFO("m = " << pieces.m);
    const auto [x, y] = pieces_of(pieces, generator);
    const IntersectResult result = intersect(x, y);
    REQUIRE(result.status == Status::complete);
    const Node* cusp = node_of_kind(result.graph, NodeKind::cusp);
    REQUIRE(cusp != nullptr);
    CHECK(std::ranges::count(cusp->kinds, NodeKind::boundary) == 1);
    CHECK(std::ranges::count(cusp->kinds, NodeKind::end_of_overlap) == 1);
    CHECK(ends_at(result.graph.arcs, cusp->id) == 1);
    CHECK(ends_on_rims(result.graph, cusp->id) == 2);
    check_all_ways(x, y, result);
  }
}

TEST_CASE("two pieces: a cuspidal point on the edge of neighbours, from which a curve starts") {
  std::mt19937_64 generator(7);
  const Rational half = q(1, 2);
  for (const PiecesAtCusp& pieces : {PiecesAtCusp{1, {0, half, 0, 1}, {half, 1, 0, 1}},
                                     PiecesAtCusp{1, {0, half, 0, 1}, {half, 1, half, 1}},
                                     PiecesAtCusp{-1, {0, half, half, 1}, {1, half, 0, 1}}}) {
    INFO("m = " << pieces.m);
    const auto [x, y] = pieces_of(pieces, generator);
    const IntersectResult result = intersect(x, y);
    REQUIRE(result.status == Status::complete);
    CHECK(result.graph.overlaps.empty());
    const Node* cusp = node_of_kind(result.graph, NodeKind::cusp);
    REQUIRE(cusp != nullptr);
    const bool corner = pieces.first[2] == half || pieces.second[2] == half;
    CHECK(std::ranges::count(cusp->kinds, NodeKind::corner) == (corner ? 1 : 0));
    CHECK(ends_at(result.graph.arcs, cusp->id) == (corner ? 2 : 3));
    check_all_ways(x, y, result);
  }
}

TEST_CASE("two pieces: neighbours that meet in closed and open curves, with some turning points as nodes") {
  const BezierPatch whole = with_closed_curve();
  const BezierPatch x = whole.restricted_to(0, q(3, 8), 0, 1);
  const BezierPatch y = whole.restricted_to(q(3, 8), 1, 0, 1);
  const IntersectResult result = intersect(x, y);
  REQUIRE(result.status == Status::complete);
  CHECK(result.graph.count(ComponentShape::closed) == 1);
  check_all_ways(x, y, result);
  for (const std::vector<Parameter>& turning :
       {std::vector<Parameter>{}, {Parameter::r}, {Parameter::u, Parameter::s}}) {
    IntersectOptions options;
    options.turning = turning;
    const IntersectResult some = intersect(x, y, options);
    REQUIRE(some.status == Status::complete);
    CHECK(unsound(x, y, some) == "");
    CHECK(some.graph.components.size() == result.graph.components.size());
    CHECK(some.graph.boundary_points() == result.graph.boundary_points());
    for (const Component& component : some.graph.components)
      if (turning.empty()) CHECK((component.shape == ComponentShape::open) == (component.arcs.size() == 1));
    if (turning.empty()) continue;
    for (const Parameter p : all_parameters) {
      const int all = result.graph.turning_points(p);
      CHECK(all > 0);
      CHECK(some.graph.turning_points(p) == (std::ranges::count(turning, p) > 0 ? all : 0));
    }
  }
}

TEST_CASE("two pieces: a closed curve appears in both orders") {
  const BezierPatch x = with_closed_curve();
  const IntersectResult self = self_intersect(x);
  const IntersectResult result = intersect(x, x.restricted_to(q(1, 1000000), 1, 0, 1));
  CHECK(result.status == Status::complete);
  const auto loops = [](const IntersectionGraph& graph) {
    return std::count_if(graph.components.begin(), graph.components.end(),
                         [](const Component& c) { return c.shape == ComponentShape::closed; });
  };
  REQUIRE(loops(self.graph) > 0);
  CHECK(loops(result.graph) == 2 * loops(self.graph));
}

/// A patch with x(p) = x(q), p = (1/4,1/3), q = (3/4,2/3), and x_v(p) in its tangent plane at q: there the
/// curve of its pairs turns in the first parameter of p.
BezierPatch with_turning_pair(std::mt19937_64& generator) {
  const auto digit = [&] { return Rational(static_cast<int>(generator() % 19) - 9); };
  ControlNet c{};
  for (auto& row : c)
    for (Point& point : row) point = {digit(), digit(), digit()};
  // Linear in the coefficients: those of u and of v are solved for.
  const Rational a = digit(), b = digit();
  const Rational pu = q(1, 4), pv = q(1, 3), qu = q(3, 4), qv = q(2, 3);
  const auto power = [](const Rational& t, std::size_t n) {
    return n == 0 ? Rational(1) : n == 1 ? t : t * t;
  };
  const auto slope = [](const Rational& t, std::size_t n) {
    return n == 0 ? Rational(0) : n == 1 ? Rational(1) : 2 * t;
  };
  Point gap{0, 0, 0}, tilt{0, 0, 0};
  c[1][0] = c[0][1] = {0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      gap = gap + (power(qu, i) * power(qv, j) - power(pu, i) * power(pv, j)) * c[i][j];
      tilt = tilt + (a * slope(qu, i) * power(qv, j) + b * power(qu, i) * slope(qv, j) -
                     power(pu, i) * slope(pv, j)) *
                        c[i][j];
    }
  // gap + (qu - pu) c10 + (qv - pv) c01 = 0, tilt + a c10 + (b - 1) c01 = 0
  const Rational e = qu - pu, f = qv - pv, g = b - 1, determinant = e * g - f * a;
  c[1][0] = Rational(1 / determinant) * (f * tilt - g * gap);
  c[0][1] = Rational(1 / determinant) * (a * gap - e * tilt);
  return BezierPatch::from_power_basis(c);
}

TEST_CASE("two pieces: a turning point in one order of a pair, on a side in the other one") {
  std::mt19937_64 generator(9);
  for (int i = 0; i < 4; ++i) {
    INFO("pair " << i << " of seed 9");
    const BezierPatch x = with_turning_pair(generator);
    const BezierPatch y = x.restricted_to(q(1, 4), q(5, 4), 0, 1);
    const IntersectResult result = intersect(x, y);
    REQUIRE(result.status == Status::complete);
    const auto turns = std::ranges::find_if(result.graph.nodes, [](const Node& node) {
      return std::ranges::count(node.wrt, Parameter::u) > 0 && std::fabs(node.approx[0] - 0.25) < 1e-9 &&
             std::fabs(node.approx[1] - 1.0 / 3) < 1e-9;
    });
    REQUIRE(turns != result.graph.nodes.end());
    CHECK(turns->kinds == std::vector{NodeKind::turning});
    CHECK(ends_at(result.graph.arcs, turns->id) == 2);
    check_all_ways(x, y, result);
  }
}

TEST_CASE("two pieces of random crumpled patches") {
  random_pairs::Generator generator(8);
  int complete = 0;
  constexpr int kPairs = 6;
  for (int i = 0; i < kPairs; ++i) {
    INFO("pair " << i << " of seed 8");
    const BezierPatch x = random_pairs::scattered(generator).x;
    const BezierPatch y = x.restricted_to(q(i, 24), 1 + q(i, 30), 1 - q(i, 20), q(-i, 60));
    const IntersectResult result = intersect(x, y);
    for (const Incomplete& region : result.incomplete) UNSCOPED_INFO(i << ": " << region.why);
    complete += result.status == Status::complete ? 1 : 0;
    check_all_ways(x, y, result);
  }
  CHECK(complete == kPairs);
}

}  // namespace exsect::two_pieces_test
