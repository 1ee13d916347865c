// Laws that hold for every patch against itself, closed curves, and agreement with exact fibres and with the
// oracle for pairs.
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/self_intersect.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/oracle.h"
#include "support/random_pairs.h"
#include "support/self_locus.h"
#include "support/self_orders.h"

namespace exsect::intersect_property_test {
namespace {

using random_pairs::Generator;
using Family = BezierPatch (*)(Generator&);

BezierPatch integers(Generator& generator, long largest) {
  ControlNet net;
  for (auto& row : net)
    for (Point& p : row)
      for (Rational& c : p) c = random_pairs::integer(generator, -largest, largest);
  return BezierPatch(net);
}

/// Crumpled: usually one to three curves.
BezierPatch scattered(Generator& generator) { return integers(generator, 1000); }
/// More of the surface, strongly folded.
BezierPatch extended(Generator& generator) { return integers(generator, 50).restricted_to(-1, 2, -1, 2); }
/// 53 random bits.
BezierPatch doubles(Generator& generator) {
  ControlNet net;
  for (auto& row : net)
    for (Point& p : row)
      for (Rational& c : p) c = from_double(static_cast<double>(generator() >> 11U) * 0x1p-53);
  return BezierPatch(net);
}

BezierPatch net(const std::array<std::array<int, 3>, 9>& points) {
  ControlNet result;
  for (std::size_t i = 0; i < 9; ++i) result[i / 3][i % 3] = {points[i][0], points[i][1], points[i][2]};
  return BezierPatch(result);
}

struct Change {
  const char* name;
  std::function<BezierPatch(const BezierPatch&, Generator&)> apply;
  Renaming renaming;
};

std::vector<Change> changes() {
  return {
      {"u and v exchanged",
       [](const BezierPatch& x, Generator&) { return x.exchanged(); },
       {{1, 0, 3, 2}, {}}},
      {"u reversed",
       [](const BezierPatch& x, Generator&) { return x.reversed_first(); },
       {{0, 1, 2, 3}, {true, false, true, false}}},
      {"v reversed",
       [](const BezierPatch& x, Generator&) { return x.reversed_second(); },
       {{0, 1, 2, 3}, {false, true, false, true}}},
      {"mapped affinely",
       [](const BezierPatch& x, Generator& generator) { return random_pairs::affine_map(generator)(x); },
       {}},
  };
}

void check_changes(Family family, std::uint64_t count) {
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    Generator generator(seed);
    const BezierPatch x = family(generator);
    const auto result = self_intersect(x);
    for (const Change& change : changes()) {
      INFO("seed " << seed << ", " << change.name);
      const auto other = self_intersect(change.apply(x, generator));
      CHECK(other.status == result.status);
      CHECK(difference(testing::in_both_orders(result.graph), testing::in_both_orders(other.graph),
                       change.renaming) == "");
    }
  }
}

/// Complete, and as many crossings of parameter lines as their exact fibres have points.
void check_fibres(const BezierPatch& x, int samples) {
  const auto result = self_intersect(x);
  REQUIRE(result.status == Status::complete);
  for (const std::size_t parameter : {0U, 1U})
    for (int k = 0; k < samples; ++k) {
      const Rational value(2 * k + 1, 2 * samples + 1);
      CAPTURE(parameter, value);
      CHECK(testing::polyline_crossings(result.graph, parameter, to_double(value)) ==
            static_cast<int>(testing::self_fibre(x, parameter, value).size()));
    }
}

void check_fibres(Family family, std::uint64_t count) {
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    check_fibres(family(generator), 6);
  }
}

double distance(const oracle::Vector4& p, const IntersectionGraph& graph) {
  double best = 1;
  for (const Arc& arc : graph.arcs)
    for (std::size_t i = 0; i + 1 < arc.polyline.size(); ++i)
      for (const std::size_t shift : {0U, 2U}) {
        const auto& a = arc.polyline[i].parameters;
        const auto& b = arc.polyline[i + 1].parameters;
        double along = 0;
        double length2 = 1e-300;
        for (std::size_t j = 0; j < 4; ++j) {
          along += (p[(j + shift) % 4] - a[j]) * (b[j] - a[j]);
          length2 += (b[j] - a[j]) * (b[j] - a[j]);
        }
        const double t = std::clamp(along / length2, 0.0, 1.0);
        double d = 0;
        for (std::size_t j = 0; j < 4; ++j)
          d = std::max(d, std::fabs(a[j] + t * (b[j] - a[j]) - p[(j + shift) % 4]));
        best = std::min(best, d);
      }
  return best;
}

/// Two pieces of one patch that do not touch in its parameters: what the oracle finds of their intersection
/// is on the self-intersection of the whole.
int check_pieces(const BezierPatch& x) {
  const auto result = self_intersect(x);
  REQUIRE(result.status == Status::complete);
  const Rational a(9, 20);
  const Rational b(11, 20);
  const auto found = oracle::intersect(x.restricted_to(0, a, 0, 1), x.restricted_to(b, 1, 0, 1));
  int points = 0;
  for (const oracle::Curve& curve : found.curves)
    for (const oracle::Vector4& p : curve.points) {
      const oracle::Vector4 whole = {p[0] * 0.45, p[1], 0.55 + 0.45 * p[2], p[3]};
      CHECK(distance(whole, result.graph) < 1e-2);
      ++points;
    }
  return points;
}

}  // namespace

TEST_CASE("self_intersect: parameters exchanged, reversed, affine maps") {
  check_changes(scattered, 3);
  check_changes(extended, 1);
}

TEST_CASE("self_intersect: random patches agree with exact fibres") {
  check_fibres(scattered, 6);
  check_fibres(extended, 1);
  check_fibres(doubles, 2);
}

TEST_CASE("self_intersect: pieces of a patch agree with the oracle for pairs") {
  int points = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    points += check_pieces(scattered(generator));
  }
  CHECK(points > 40);
}

TEST_CASE("self_intersect: small integers in special position") {
  // A curve that turns where it leaves the square.
  check_fibres(net({{{2, 0, 1},
                     {-1, 2, 1},
                     {0, -2, 1},
                     {1, -2, 1},
                     {1, -2, 0},
                     {0, -2, 2},
                     {-2, 2, 1},
                     {0, -1, -1},
                     {1, -1, -1}}}),
               4);
  // The same at points of degree 2.
  check_fibres(net({{{0, 0, 1},
                     {0, 1, -1},
                     {0, -1, 0},
                     {0, 0, 1},
                     {0, -1, 0},
                     {0, 1, 0},
                     {-1, 1, 1},
                     {1, 0, 1},
                     {1, 1, 1}}}),
               4);
  check_fibres(net({{{0, 1, 1},
                     {0, -1, -1},
                     {-1, -1, 0},
                     {0, 0, 0},
                     {0, 1, 1},
                     {-1, -1, 0},
                     {1, 0, 0},
                     {0, 1, 1},
                     {-1, 1, 0}}}),
               4);
  // Two corners in one point of space, tangent planes that contain sides of the other one.
  const BezierPatch corners = net({{{0, 0, 0},
                                    {0, -1, -1},
                                    {0, 1, 0},
                                    {1, -1, -1},
                                    {1, 0, -1},
                                    {-1, 1, 0},
                                    {-1, 0, 0},
                                    {0, 0, 1},
                                    {0, 0, 0}}});
  check_fibres(corners, 4);
  const IntersectionGraph graph = self_intersect(corners).graph;
  REQUIRE(graph.isolated_points.size() == 1);
  CHECK(graph.nodes[static_cast<std::size_t>(graph.isolated_points[0])].on.size() == 4);
  // x_u = 0 in the corner (0,0), with x_uu, x_uv and x_v in one plane.
  check_fibres(net({{{0, 1, 0},
                     {1, 1, -1},
                     {0, -1, 0},
                     {0, 1, 0},
                     {-1, 1, 0},
                     {0, 1, 1},
                     {-1, 1, 0},
                     {-1, 0, 0},
                     {1, -1, -1}}}),
               4);
  check_fibres(net({{{-1, 0, -1},
                     {1, 1, 0},
                     {-1, -1, 1},
                     {1, 1, 0},
                     {1, 1, -1},
                     {1, 1, 1},
                     {0, -1, 1},
                     {0, -1, 1},
                     {0, -1, 0}}}),
               4);
}

TEST_CASE("self_intersect: a curve that joins cuspidal points, from either of them") {
  const BezierPatch x = net({{{0, -1, 0},
                              {0, 2, 2},
                              {0, 0, 0},
                              {1, 0, -1},
                              {-2, 1, 0},
                              {2, -2, 1},
                              {-1, 1, 0},
                              {2, -1, 0},
                              {1, -2, -2}}});
  check_fibres(x, 4);
  check_fibres(x.exchanged(), 4);
}

TEST_CASE("self_intersect: a side that lies on another one") {
  // x(1,v) = x(0, (v+a)/2), c = x(0,.) a parabola.
  const auto blossom = [](const Rational& a, const Rational& b) -> Point {
    return {2 * (a + b), 4 * a * b - (a + b) / 2, 0};
  };
  for (const Rational& shift : {Rational(3, 2), Rational(7, 5), Rational(-2, 3)}) {
    CAPTURE(shift);
    const Rational from = shift / 2;
    const Rational to = (shift + 1) / 2;
    const ControlNet glued = {{{blossom(0, 0), blossom(0, 1), blossom(1, 1)},
                               {{{0, 2, 3}, {3, 3, 4}, {5, 4, 3}}},
                               {blossom(from, from), blossom(from, to), blossom(to, to)}}};
    const BezierPatch x(glued);
    const auto result = self_intersect(x);
    REQUIRE(result.status == Status::complete);
    int on_sides = 0;
    for (const Arc& arc : result.graph.arcs) {
      if (arc.place != ArcPlace::patch_boundary) continue;
      ++on_sides;
      const bool first = arc.polyline.front().parameters[0] == 0;
      for (const PolylineVertex& vertex : arc.polyline) {
        const std::array<double, 4>& p = vertex.parameters;
        CHECK(p[first ? 0 : 2] == 0);
        CHECK(p[first ? 2 : 0] == 1);
        CHECK(std::fabs(2 * p[first ? 1 : 3] - p[first ? 3 : 1] - to_double(shift)) < 1e-9);
      }
    }
    CHECK(on_sides == 1);
    check_fibres(x, 4);
    CHECK(self_intersect(x.exchanged()).graph.arcs.size() == result.graph.arcs.size());
    CHECK(self_intersect(x.reversed_first()).graph.arcs.size() == result.graph.arcs.size());
  }
}

TEST_CASE("self_intersect: scattered patches with glued opposite sides") {
  for (const std::string file : {"glued-seam", "glued-kind0", "glued-kind3"}) {
    CAPTURE(file);
    const BezierPatch x =
        read_patches(std::string(EXSECT_CASES) + "/found/" + file + ".json").patches.at(0).patch;
    const std::clock_t begin = std::clock();
    const IntersectionGraph graph = self_intersect(x).graph;
    CHECK(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC < 15);
    check_fibres(x, 4);
    const auto same = [&](const BezierPatch& image) {
      const IntersectResult other = self_intersect(image);
      CHECK(other.status == Status::complete);
      CHECK(other.graph.nodes.size() == graph.nodes.size());
      CHECK(other.graph.arcs.size() == graph.arcs.size());
      CHECK(other.graph.components.size() == graph.components.size());
    };
    same(x.exchanged());
    same(x.reversed_second());
  }
}

TEST_CASE("self_intersect: closed curves") {
  const BezierPatch first =
      net({{{30, -34, -22},
            {21, 14, -2},
            {-45, -12, 3},
            {-5, 39, 36},
            {-11, 49, -30},
            {14, -8, -23},
            {41, -8, 41},
            {-16, -26, 43},
            {25, -36, -10}}})
          .restricted_to(Rational(-1, 2), Rational(15, 8), Rational(-4, 5), Rational(4, 3));
  const BezierPatch second = net({{{48, 12, 6},
                                   {19, 3, -50},
                                   {-11, 16, -37},
                                   {-41, -48, -29},
                                   {-45, 44, -45},
                                   {-44, 9, -4},
                                   {-36, -44, 28},
                                   {-3, 41, -22},
                                   {13, 26, -8}}})
                                 .restricted_to(-4, 5, -4, 5);
  for (const BezierPatch& x : {first, second}) {
    const auto result = self_intersect(x);
    REQUIRE(result.status == Status::complete);
    CHECK(result.graph.count(ComponentShape::closed) == 1);
    check_fibres(x, 7);
    // A closed curve keeps its turning points as nodes.
    IntersectOptions options;
    options.turning = {};
    const auto plain = self_intersect(x, options);
    CHECK(plain.status == Status::complete);
    CHECK(plain.graph.count(ComponentShape::closed) == 1);
  }
}

}  // namespace exsect::intersect_property_test
