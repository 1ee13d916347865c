// Moved, scaled and exchanged: the same graph, bounds that hold, and a drawing that says how fine it is.
#include "answer/placement.h"

#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>
#include <exsect/solver/self_intersect.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/catch.h"
#include "support/families.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"

namespace exsect::placement_test {
namespace {

Rational number(const std::string& text) { return Rational(text); }

Rational power_of_ten(int n) {
  Rational result = 1;
  for (int i = 0; i < std::abs(n); ++i) result *= 10;
  return n < 0 ? Rational(1 / result) : result;
}

struct Similarity {
  std::string name;
  Rational scale;
  Point shift;

  Point operator()(const Point& p) const { return scale * p + shift; }
  BezierPatch operator()(const BezierPatch& patch) const {
    ControlNet net = patch.net();
    for (auto& row : net)
      for (Point& p : row) p = (*this)(p);
    return BezierPatch(net);
  }
};

std::vector<Similarity> similarities() {
  const Point none = {0, 0, 0};
  const Point far = {number("100000000"), number("-30000000001/10"), number("1/3")};
  return {{"by 1e8", 1, {number("100000000"), number("100000000"), number("100000000")}},
          {"far, and 25.4", number("127/5"), far},
          {"25.4", number("127/5"), none},
          {"beyond the last digit", 1, {power_of_ten(30), 0, power_of_ten(17)}},
          {"2^-1074", power_of_two(-1074), none},
          {"2^-500", power_of_two(-500), none},
          {"2^1000", power_of_two(1000), none},
          {"1e-400", power_of_ten(-400), none},
          {"1e400", power_of_ten(400), none},
          {"1e400 beside 1e420", power_of_ten(400), {power_of_ten(420), 0, 0}}};
}

/// sum of |coordinates|, not below the distance.
Rational distance(const Point& p, const std::array<double, 3>& q) {
  Rational sum = 0;
  for (std::size_t c = 0; c < 3; ++c) sum += abs(p[c] - from_double(q[c]));
  return sum;
}

/// Every vertex is within the arc's bound of the point of its own parameters, which are rounded to doubles:
/// 2^-40 of the extent allows for that.
void check_bounds(const BezierPatch& x, const Rational& extent, const IntersectionGraph& graph) {
  for (const Arc& arc : graph.arcs) {
    if (!std::isfinite(arc.error_bound)) continue;
    const Rational bound = 2 * from_double(arc.error_bound) + power_of_two(-40) * extent;
    for (const PolylineVertex& v : arc.polyline)
      REQUIRE(distance(x(from_double(v.parameters[0]), from_double(v.parameters[1])), v.point) <= bound);
  }
}

bool has_finite_points(const IntersectionGraph& graph) {
  return std::ranges::all_of(graph.nodes, [](const Node& node) {
    return std::ranges::all_of(node.point, [](double c) { return std::isfinite(c); });
  });
}

void check(const BezierPatch& x, const BezierPatch& y, const Similarity& moved,
           const IntersectionGraph& there) {
  INFO(moved.name);
  const BezierPatch a = moved(x);
  const BezierPatch b = moved(y);
  const IntersectResult result = intersect(a, b);
  CHECK(result.status == Status::complete);
  CHECK(difference(result.graph, there, {}) == "");
  if (has_finite_points(result.graph)) check_bounds(a, model_extent(a, b), result.graph);
  for (const Arc& arc : result.graph.arcs)
    CHECK((result.coarse || arc.error_bound <= 1e-6 * to_double(model_extent(a, b))));
}

}  // namespace

TEST_CASE("placement: none for ordinary models") {
  for (const ExactCase& c : families::specimens()) CHECK(!Placement::of(c.x, c.y));
}

TEST_CASE("placement: about the origin, of extent in [1/2, 1)") {
  random_pairs::Generator generator(1);
  const random_pairs::Pair pair = random_pairs::doubles(generator);
  for (const Similarity& moved : similarities()) {
    if (moved.name == "25.4") continue;
    INFO(moved.name);
    const BezierPatch x = moved(pair.x);
    const BezierPatch y = moved(pair.y);
    const auto place = Placement::of(x, y);
    REQUIRE(place);
    const BezierPatch placed = place->placed(x);
    const Rational extent = model_extent(placed, place->placed(y));
    CHECK(extent >= Rational(1, 2));
    CHECK(extent < 1);
    for (const auto& row : placed.net())
      for (const Point& p : row)
        for (const Rational& c : p) CHECK(abs(c) <= 1);
    CHECK(!Placement::of(placed, place->placed(y)));
  }
}

TEST_CASE("placement: points are put back within the bound of their rounding") {
  const BezierPatch x = similarities()[1](families::specimens().front().x);
  const auto place = Placement::of(x, x);
  REQUIRE(place);
  IntersectionGraph graph;
  for (const std::array<double, 3>& q :
       {std::array{0.3, -0.4, 0.125}, {0.1, 0.7, -0x1p-60}, {0.0, -0.0, 1e-300}}) {
    Arc arc{};
    arc.error_bound = 1e-12;
    arc.polyline = {{{}, q}};
    graph.arcs = {arc};
    place->restore(graph);
    const Arc& moved = graph.arcs.front();
    // Where the control points of q as a patch go back to is known exactly.
    const BezierPatch inverse = place->placed(x);
    const Rational scale =
        (x.net()[0][0][0] - x.net()[2][2][0]) / (inverse.net()[0][0][0] - inverse.net()[2][2][0]);
    Point exact;
    for (std::size_t c = 0; c < 3; ++c)
      exact[c] = x.net()[0][0][c] + scale * (from_double(q[c]) - inverse.net()[0][0][c]);
    const Rational rounding = from_double(moved.error_bound) - scale * from_double(1e-12);
    CHECK(rounding > 0);
    CHECK(distance(exact, moved.polyline.front().point) <= rounding);
    CHECK(rounding < Rational(1, 100000));
  }
}

TEST_CASE("placement: generic pairs anywhere and of any size") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    INFO("seed " << seed);
    random_pairs::Generator generator(seed);
    const random_pairs::Pair pair =
        seed % 2 == 0 ? random_pairs::doubles(generator) : random_pairs::scattered(generator);
    const IntersectionGraph there = intersect(pair.x, pair.y).graph;
    for (const Similarity& moved : similarities()) check(pair.x, pair.y, moved, there);
  }
}

TEST_CASE("placement: special pairs anywhere and of any size") {
  for (const ExactCase& c : families::specimens()) {
    INFO(c.name);
    const IntersectResult there = intersect(c.x, c.y);
    if (there.status != Status::complete) continue;
    for (const Similarity& moved : {similarities()[0], similarities()[4]})
      check(c.x, c.y, moved, there.graph);
  }
}

TEST_CASE("placement: exchanged patches give the same graph") {
  random_pairs::Generator generator(2);
  const random_pairs::Pair pair = random_pairs::doubles(generator);
  for (const Similarity& moved : similarities()) {
    INFO(moved.name);
    const auto one = intersect(moved(pair.x), moved(pair.y));
    const auto other = intersect(moved(pair.y), moved(pair.x));
    Renaming renaming;
    renaming.to = {2, 3, 0, 1};
    CHECK(difference(one.graph, other.graph, renaming) == "");
  }
}

TEST_CASE("placement: a patch and itself") {
  const BezierPatch x =
      read_patches(std::string(EXSECT_EXAMPLES) + "/chapter9-second.json").patches.at(1).patch;
  const IntersectionGraph there = self_intersect(x).graph;
  REQUIRE(there.arcs.size() > 1);
  for (const Similarity& moved : similarities()) {
    INFO(moved.name);
    const IntersectResult result = self_intersect(moved(x));
    CHECK(result.status == Status::complete);
    CHECK(difference(result.graph, there, {}) == "");
    if (has_finite_points(result.graph))
      check_bounds(moved(x), model_extent(moved(x), moved(x)), result.graph);
  }
}

TEST_CASE("placement: what doubles cannot write is drawn coarsely, and complete") {
  random_pairs::Generator generator(2);
  const random_pairs::Pair pair = random_pairs::doubles(generator);
  const auto drawn = [&](const Point& shift, double tolerance) {
    IntersectOptions options;
    options.tolerance = tolerance;
    const Similarity moved = {"", 1, shift};
    return intersect(moved(pair.x), moved(pair.y), options);
  };
  const double extent = to_double(model_extent(pair.x, pair.y));
  const Rational e8 = power_of_ten(8);
  const IntersectResult kept = drawn({e8, e8, e8}, 1e-6);
  CHECK(!kept.coarse);
  const IntersectResult coarse = drawn({e8, e8, e8}, 1e-9);
  CHECK(coarse.status == Status::complete);
  REQUIRE(coarse.coarse);
  CHECK(coarse.coarse->tolerance == Approx(1e-9 * extent));
  CHECK(coarse.coarse->bound > 1e-9 * extent);
  CHECK(coarse.coarse->bound < 1e-6);
  const IntersectResult beyond = drawn({power_of_ten(400), 0, 0}, 1e-6);
  CHECK(beyond.status == Status::complete);
  REQUIRE(beyond.coarse);
  CHECK(std::isinf(beyond.coarse->bound));
  CHECK(std::isinf(beyond.graph.nodes.front().point[0]));
  CHECK(std::isfinite(beyond.graph.nodes.front().point[1]));
}

}  // namespace exsect::placement_test
