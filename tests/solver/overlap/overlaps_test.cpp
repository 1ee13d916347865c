// Patches on one surface: overlap regions, shared edges and corners with exact expected parameters, and the
// laws of exchange.
#include "overlap/overlaps.h"

#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "support/catch.h"
#include "support/chain_checks.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"
#include "support/renaming_checks.h"

namespace exsect::overlaps_test {
namespace {

using random_pairs::Pair;

Rational q(int a, int b) { return {a, b}; }

const BezierPatch& chapter_patch() {
  static const BezierPatch x = read_patches(EXSECT_EXAMPLES "/chapter9-first.json").patches.at(0).patch;
  return x;
}

/// (a, b, a^2 + b^2) for the bilinear a = a0 + a1 u + a2 v + a3 u v, b likewise.
BezierPatch paraboloid(const std::array<Rational, 4>& a, const std::array<Rational, 4>& b) {
  ControlNet c;
  for (auto& row : c) row.fill(Point{0, 0, 0});
  for (std::size_t i = 0; i < 4; ++i) {
    c[i % 2][i / 2][0] = a[i];
    c[i % 2][i / 2][1] = b[i];
    for (std::size_t j = 0; j < 4; ++j) c[i % 2 + j % 2][i / 2 + j / 2][2] += a[i] * a[j] + b[i] * b[j];
  }
  return BezierPatch::from_power_basis(c);
}

using Place = std::array<Rational, 4>;

bool is_at(const Node& node, const Place& place) {
  for (std::size_t j = 0; j < 4; ++j)
    if (place[j] < node.box[j].lower || node.box[j].upper < place[j] ||
        node.box[j].width() > power_of_two(-45))
      return false;
  return true;
}

/// A chain is closed, each arc begins where the one before ends, and its vertices lie on both patches.
void check_chain(const Pair& pair, const IntersectionGraph& graph, const std::vector<Arc>& chain) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Arc& arc = chain[i];
    CHECK(arc.to == chain[(i + 1) % chain.size()].from);
    CHECK(arc.place == ArcPlace::patch_boundary);
    const std::array<int, 2> ends = {arc.from, arc.to};
    for (const std::size_t end : {0, 1}) {
      const Node& node = graph.nodes.at(static_cast<std::size_t>(ends[end]));
      const auto& vertex = end == 0 ? arc.polyline.front() : arc.polyline.back();
      for (std::size_t j = 0; j < 4; ++j) CHECK(vertex.parameters[j] == Approx(node.approx[j]).margin(1e-9));
    }
    for (std::size_t k = 0; k < arc.polyline.size(); k += 1 + arc.polyline.size() / 7) {
      const auto& z = arc.polyline[k].parameters;
      const Point a = pair.x(from_double(z[0]), from_double(z[1]));
      const Point b = pair.y(from_double(z[2]), from_double(z[3]));
      for (std::size_t c = 0; c < 3; ++c) CHECK(to_double(a[c]) == Approx(to_double(b[c])).margin(1e-9));
    }
  }
}

/// Complete: these overlaps, each given by its corners in any order, and nothing else.
void check_overlaps(const Pair& pair, const std::vector<std::vector<Place>>& overlaps) {
  const IntersectResult result = intersect(pair.x, pair.y);
  check_complete(result);
  const IntersectionGraph& graph = result.graph;
  CHECK(graph.arcs.empty());
  CHECK(graph.isolated_points.empty());
  REQUIRE(graph.overlaps.size() == overlaps.size());
  for (const std::vector<Place>& corners : overlaps) {
    const auto corresponds = [&](const Overlap& overlap) {
      const std::vector<Arc>& chain = overlap.chains.front();
      return overlap.chains.size() == 1 && chain.size() == corners.size() &&
             std::all_of(chain.begin(), chain.end(), [&](const Arc& arc) {
               const Node& node = graph.nodes.at(static_cast<std::size_t>(arc.from));
               return std::any_of(corners.begin(), corners.end(),
                                  [&](const Place& place) { return is_at(node, place); });
             });
    };
    CHECK(std::count_if(graph.overlaps.begin(), graph.overlaps.end(), corresponds) == 1);
  }
  for (const Overlap& overlap : graph.overlaps)
    for (const std::vector<Arc>& chain : overlap.chains) check_chain(pair, graph, chain);
  check_renamings(pair, graph);
}

TEST_CASE("a patch and its affinely reparametrised neighbour overlap") {
  const BezierPatch& x = chapter_patch();
  const BezierPatch y = x.restricted_to(q(1, 3), q(4, 3), q(-1, 4), q(3, 4));
  check_overlaps({x, y}, {{{q(1, 3), 0, 0, q(1, 4)},
                           {1, 0, q(2, 3), q(1, 4)},
                           {1, q(3, 4), q(2, 3), 1},
                           {q(1, 3), q(3, 4), 0, 1}}});
}

TEST_CASE("a patch and itself, and a sub-patch") {
  const BezierPatch& x = chapter_patch();
  check_overlaps({x, x}, {{{0, 0, 0, 0}, {1, 0, 1, 0}, {1, 1, 1, 1}, {0, 1, 0, 1}}});
  const BezierPatch inner = x.restricted_to(q(1, 5), q(3, 4), q(1, 7), q(2, 3));
  check_overlaps({x, inner}, {{{q(1, 5), q(1, 7), 0, 0},
                               {q(3, 4), q(1, 7), 1, 0},
                               {q(3, 4), q(2, 3), 1, 1},
                               {q(1, 5), q(2, 3), 0, 1}}});
  // Half of it: three sides in common.
  check_overlaps({x, x.restricted_to(q(1, 2), q(3, 2), 0, 1)},
                 {{{q(1, 2), 0, 0, 0}, {1, 0, q(1, 2), 0}, {1, 1, q(1, 2), 1}, {q(1, 2), 1, 0, 1}}});
}

TEST_CASE("dyadic patches with long coordinates overlap") {
  random_pairs::Generator generator(5);
  const BezierPatch x = random_pairs::doubles(generator).x;
  check_overlaps({x, x.restricted_to(q(1, 2), q(3, 2), q(-1, 4), q(3, 4))}, {{{q(1, 2), 0, 0, q(1, 4)},
                                                                              {1, 0, q(1, 2), q(1, 4)},
                                                                              {1, q(3, 4), q(1, 2), 1},
                                                                              {q(1, 2), q(3, 4), 0, 1}}});
}

TEST_CASE("ruled surfaces overlap") {
  const BezierPatch saddle = power({{{1, 0}, {1, 0, 0}}, {{0, 1}, {0, 1, 0}}, {{1, 1}, {0, 0, 1}}});
  check_overlaps({saddle, saddle.restricted_to(q(1, 3), q(4, 3), q(-1, 4), q(3, 4))},
                 {{{q(1, 3), 0, 0, q(1, 4)},
                   {1, 0, q(2, 3), q(1, 4)},
                   {1, q(3, 4), q(2, 3), 1},
                   {q(1, 3), q(3, 4), 0, 1}}});
  // The cylinder (u, v, u^2) and u = 1/4 + r, v = 1/4 + r^2/2 + s + r s/3 on it.
  const BezierPatch cylinder = power({{{1, 0}, {1, 0, 0}}, {{2, 0}, {0, 0, 1}}, {{0, 1}, {0, 1, 0}}});
  const BezierPatch slanted = power({{{0, 0}, {q(1, 4), q(1, 4), q(1, 16)}},
                                     {{1, 0}, {1, 0, q(1, 2)}},
                                     {{2, 0}, {0, q(1, 2), 1}},
                                     {{0, 1}, {0, 1, 0}},
                                     {{1, 1}, {0, q(1, 3), 0}}});
  check_overlaps({cylinder, slanted}, {{{q(1, 4), q(1, 4), 0, 0},
                                        {1, q(17, 32), q(3, 4), 0},
                                        {1, 1, q(3, 4), q(3, 8)},
                                        {q(1, 4), 1, 0, q(3, 4)}}});
}

TEST_CASE("a quadric reparametrised bilinearly overlaps") {
  // u = (1 + r + s/2)/4, v = (1 + s - r/2 + r s)/4 on the paraboloid: all of y lies inside x.
  const BezierPatch x = paraboloid({0, 1, 0, 0}, {0, 0, 1, 0});
  const BezierPatch y = paraboloid({q(1, 4), q(1, 4), q(1, 8), 0}, {q(1, 4), q(-1, 8), q(1, 4), q(1, 4)});
  check_overlaps({x, y}, {{{q(1, 4), q(1, 4), 0, 0},
                           {q(1, 2), q(1, 8), 1, 0},
                           {q(5, 8), q(5, 8), 1, 1},
                           {q(3, 8), q(1, 2), 0, 1}}});
}

TEST_CASE("two planar patches in one plane") {
  const BezierPatch square = power({{{1, 0}, {1, 0, 0}}, {{0, 1}, {0, 1, 0}}});
  // A parallelogram: (1/2, 1/2) + r (1, 1/2) + s (-1/2, 1).
  const BezierPatch tilted =
      power({{{0, 0}, {q(1, 2), q(1, 2), 0}}, {{1, 0}, {1, q(1, 2), 0}}, {{0, 1}, {q(-1, 2), 1, 0}}});
  check_overlaps({square, tilted}, {{{q(1, 2), q(1, 2), 0, 0},
                                     {1, q(3, 4), q(1, 2), 0},
                                     {1, 1, q(3, 5), q(1, 5)},
                                     {q(1, 4), 1, 0, q(1, 2)}}});
  // Between parabolas v = 1/2 - 3 r + 3 r^2 and 1/5 above it: the middle leaves the square, two regions.
  const BezierPatch bent = power(
      {{{0, 0}, {0, q(1, 2), 0}}, {{1, 0}, {1, -3, 0}}, {{2, 0}, {0, 3, 0}}, {{0, 1}, {0, q(1, 5), 0}}});
  const IntersectResult result = intersect(square, bent);
  check_complete(result);
  REQUIRE(result.graph.overlaps.size() == 2);
  CHECK(result.graph.nodes.size() == 8);
  // v = 0 on the lower parabola: r = 1/2 -+ sqrt(1/12).
  const double lower = 0.5 - std::sqrt(1.0 / 12);
  CHECK(std::count_if(result.graph.nodes.begin(), result.graph.nodes.end(), [&](const Node& node) {
          return std::abs(node.approx[0] - lower) < 1e-14 && node.approx[3] == 0;
        }) == 1);
  check_renamings({square, bent}, result.graph);
}

TEST_CASE("a patch that covers a part of a surface twice has two overlaps") {
  // ((2 u - 1)^2, v, v^2) over [1/16, 9/16]... y covers first coordinates in [1/16, 1/4].
  const BezierPatch folded = power({{{0, 0}, {1, 0, 0}},
                                    {{1, 0}, {-4, 0, 0}},
                                    {{2, 0}, {4, 0, 0}},
                                    {{0, 1}, {0, 1, 0}},
                                    {{0, 2}, {0, 0, 1}}});
  const BezierPatch y = power(
      {{{0, 0}, {q(1, 16), 0, 0}}, {{1, 0}, {q(3, 16), 0, 0}}, {{0, 1}, {0, 1, 0}}, {{0, 2}, {0, 0, 1}}});
  check_overlaps({folded, y},
                 {{{q(3, 8), 0, 0, 0}, {q(1, 4), 0, 1, 0}, {q(1, 4), 1, 1, 1}, {q(3, 8), 1, 0, 1}},
                  {{q(5, 8), 0, 0, 0}, {q(3, 4), 0, 1, 0}, {q(3, 4), 1, 1, 1}, {q(5, 8), 1, 0, 1}}});
}

TEST_CASE("neighbours on one surface share an edge, a part of it, or a corner") {
  const BezierPatch& x = chapter_patch();
  const Pair halves = {x.restricted_to(0, q(1, 2), 0, 1), x.restricted_to(q(1, 2), 1, q(1, 4), q(3, 4))};
  const IntersectResult edge = intersect(halves.x, halves.y);
  check_complete(edge);
  CHECK(edge.graph.overlaps.empty());
  REQUIRE(edge.graph.arcs.size() == 1);
  CHECK(edge.graph.arcs[0].place == ArcPlace::patch_boundary);
  CHECK(edge.graph.arcs[0].contact == Contact::tangential);
  REQUIRE(edge.graph.nodes.size() == 2);
  CHECK(is_at(edge.graph.nodes[0], {1, q(1, 4), 0, 0}));
  CHECK(is_at(edge.graph.nodes[1], {1, q(3, 4), 0, 1}));
  check_renamings(halves, edge.graph);

  const Pair quarters = {x.restricted_to(0, q(1, 2), 0, q(1, 2)), x.restricted_to(q(1, 2), 1, q(1, 2), 1)};
  const IntersectResult corner = intersect(quarters.x, quarters.y);
  check_complete(corner);
  CHECK(corner.graph.overlaps.empty());
  CHECK(corner.graph.arcs.empty());
  REQUIRE(corner.graph.isolated_points.size() == 1);
  CHECK(is_at(corner.graph.nodes[0], {1, 1, 0, 0}));
  CHECK(std::count(corner.graph.nodes[0].kinds.begin(), corner.graph.nodes[0].kinds.end(), NodeKind::touch) ==
        1);
  check_renamings(quarters, corner.graph);

  const IntersectResult apart =
      intersect(x.restricted_to(0, q(1, 3), 0, 1), x.restricted_to(q(1, 2), 1, 0, 1));
  check_complete(apart);
  CHECK(apart.graph.nodes.empty());
}

TEST_CASE("other sheets of the surface are met as usual") {
  // The second example's x meets itself; the sub-patch holds none of the curve's ends.
  const BezierPatch x = read_patches(EXSECT_EXAMPLES "/chapter9-second.json").patches.at(0).patch;
  const BezierPatch y = x.restricted_to(q(3, 5), q(9, 10), q(1, 2), q(9, 10));
  check_overlaps({x, y}, {{{q(3, 5), q(1, 2), 0, 0},
                           {q(9, 10), q(1, 2), 1, 0},
                           {q(9, 10), q(9, 10), 1, 1},
                           {q(3, 5), q(9, 10), 0, 1}}});
}

TEST_CASE("a patch given twice, with a side that is one point") {
  const BezierPatch cone = BezierPatch::from_power_basis({{{}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {}}});
  const auto result = intersect(cone, cone);
  CHECK(result.status == Status::complete);
  CHECK(result.graph.overlaps.size() == 1);
  CHECK(result.graph.arcs.empty());
  REQUIRE(result.graph.isolated_points.size() == 1);
  const Node& tip = result.graph.nodes[static_cast<std::size_t>(result.graph.isolated_points[0])];
  CHECK(tip.kinds == std::vector<NodeKind>{NodeKind::boundary, NodeKind::end_of_overlap});
  CHECK(tip.free == std::vector<Parameter>{Parameter::v, Parameter::s});
}

TEST_CASE("a patch given twice meets itself in both orders of its pairs") {
  const PatchFile file = read_patches(EXSECT_EXAMPLES "/chapter9-second.json");
  const BezierPatch& x = file.patches.at(0).patch;
  const IntersectResult result = intersect(x, x);
  check_complete(result);
  const IntersectionGraph& graph = result.graph;
  REQUIRE(graph.overlaps.size() == 1);
  CHECK(graph.overlaps[0].chains.at(0).size() == 4);
  // One curve from (u1,v1,u2,v2) to the cuspidal point and back in the other order.
  REQUIRE(graph.components.size() == 1);
  CHECK(graph.components[0].shape == ComponentShape::open);
  const auto has_node = [&](NodeKind kind, const std::array<double, 4>& at) {
    return std::any_of(graph.nodes.begin(), graph.nodes.end(), [&](const Node& node) {
      return std::count(node.kinds.begin(), node.kinds.end(), kind) == 1 &&
             std::equal(at.begin(), at.end(), node.approx.begin(),
                        [](double a, double b) { return std::abs(a - b) < 1e-13; });
    });
  };
  CHECK(has_node(NodeKind::boundary, {0.435436781509311, 0.743017458321801, 0.431265860133535, 0}));
  CHECK(has_node(NodeKind::boundary, {0.431265860133535, 0, 0.435436781509311, 0.743017458321801}));
  CHECK(
      has_node(NodeKind::cusp, {0.433004229933352, 0.371653919708524, 0.433004229933352, 0.371653919708524}));
  CHECK(has_node(NodeKind::end_of_overlap,
                 {0.433004229933352, 0.371653919708524, 0.433004229933352, 0.371653919708524}));
  check_renamings({x, x}, graph);

  const BezierPatch& y = file.patches.at(1).patch;
  const IntersectResult other = intersect(y, y.exchanged());
  check_complete(other);
  CHECK(other.graph.components.size() == 4);
  CHECK(other.graph.overlaps.size() == 1);
}

std::array<double, 2> in_plane(const BezierPatch& x, double a, double b) {
  const Point p = x(from_double(a), from_double(b));
  return {to_double(p[0]), to_double(p[1])};
}

/// Whether the planar regular patch y covers a point, by Newton's method from the middle; empty near its
/// sides.
std::optional<bool> covers(const BezierPatch& y, const std::array<double, 2>& point) {
  double r = 0.5;
  double s = 0.5;
  for (int i = 0; i < 30; ++i) {
    const std::array<double, 2> at = in_plane(y, r, s);
    const Point a = y.derivative_first(from_double(r), from_double(s));
    const Point b = y.derivative_second(from_double(r), from_double(s));
    const std::array<double, 4> m = {to_double(a[0]), to_double(b[0]), to_double(a[1]), to_double(b[1])};
    const double det = m[0] * m[3] - m[1] * m[2];
    const double dx = point[0] - at[0];
    const double dy = point[1] - at[1];
    r = std::clamp(r + (dx * m[3] - dy * m[1]) / det, -0.5, 1.5);
    s = std::clamp(s + (dy * m[0] - dx * m[2]) / det, -0.5, 1.5);
  }
  const double depth = std::min({r, s, 1 - r, 1 - s});
  if (std::abs(depth) < 1e-3) return std::nullopt;
  return depth > 0;
}

TEST_CASE("overlaps of random planar patches hold the sampled points that both cover") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    INFO("seed " << seed);
    random_pairs::Generator generator(seed);
    const auto grid = [&](long du, long dv) {
      ControlNet net;
      for (long i = 0; i < 3; ++i)
        for (long j = 0; j < 3; ++j)
          net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = {
              Rational(4 * i + du + random_pairs::integer(generator, -1, 1)),
              Rational(4 * j + dv + random_pairs::integer(generator, -1, 1)), Rational(0)};
      return BezierPatch(net);
    };
    const BezierPatch x = grid(0, 0);
    const BezierPatch y =
        grid(random_pairs::integer(generator, -5, 5), random_pairs::integer(generator, -5, 5));
    const IntersectResult result = intersect(x, y);
    check_complete(result);
    int covered = 0;
    for (int i = 0; i < 100; ++i) {
      const double u = 0.05 + 0.1 * (i % 10);
      const double v = 0.0513 + 0.0997 * (i / 10);
      const auto expected = covers(y, in_plane(x, u, v));
      if (!expected) continue;
      INFO("u " << u << " v " << v);
      const auto holds = [&](const Overlap& overlap) { return inside(overlap.chains.front(), u, v); };
      CHECK(std::count_if(result.graph.overlaps.begin(), result.graph.overlaps.end(), holds) ==
            (*expected ? 1 : 0));
      covered += *expected ? 1 : 0;
    }
    CHECK(covered > 0);
  }
}

TEST_CASE("a fold in a common plane lies in one overlap") {
  // (r,s) -> ((1 - 2r)^2, s): each point of the square but its side u = 0 twice, so that all (r,s) are
  // solutions.
  const BezierPatch square = power({{{1, 0}, {1, 0, 0}}, {{0, 1}, {0, 1, 0}}});
  const BezierPatch folded =
      power({{{0, 0}, {1, 0, 0}}, {{1, 0}, {-4, 0, 0}}, {{2, 0}, {4, 0, 0}}, {{0, 1}, {0, 1, 0}}});
  for (const bool is_exchanged : {false, true}) {
    const IntersectResult result = is_exchanged ? intersect(folded, square) : intersect(square, folded);
    REQUIRE(result.status == Status::complete);
    const IntersectionGraph& graph = result.graph;
    REQUIRE(graph.overlaps.size() == 1);
    CHECK(graph.arcs.empty());
    CHECK_FALSE(graph.overlaps[0].normals);
    REQUIRE(graph.overlaps[0].chains.size() == 1);
    const std::size_t u = is_exchanged ? 2 : 0, r = is_exchanged ? 0 : 2;
    double least = 1, most = 0;
    for (const Arc& arc : graph.overlaps[0].chains[0])
      for (const PolylineVertex& vertex : arc.polyline) {
        const auto& w = vertex.parameters;
        least = std::min(least, w[r]);
        most = std::max(most, w[r]);
        CHECK(std::abs(w[u] - (1 - 2 * w[r]) * (1 - 2 * w[r])) < 1e-6);
        CHECK(std::abs(w[u + 1] - w[r + 1]) < 1e-6);
      }
    CHECK(least == 0);
    CHECK(most == 1);
  }
}

TEST_CASE("patches that are close but not on one surface have no overlap") {
  const BezierPatch& x = chapter_patch();
  const BezierPatch y = x.restricted_to(q(1, 3), q(4, 3), q(-1, 4), q(3, 4));
  ControlNet net = y.net();
  net[1][1][2] += power_of_two(-60);
  CHECK(!intersect_on_one_surface(x, BezierPatch(net), {}));
  CHECK(intersect_on_one_surface(x, y, {}));
}

}  // namespace
}  // namespace exsect::overlaps_test
