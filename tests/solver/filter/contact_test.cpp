// Common corners and sides in doubles: the same graph as the exact solution, or none.
#include <cmath>
#include <set>

#include "filter/contact_finder.h"
#include "filter/filter.h"
#include "intersect_exactly.h"
#include "support/catch.h"
#include "support/families.h"
#include "support/graph_checks.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"

namespace exsect::contact_test {
namespace {

using random_pairs::Generator;
using random_pairs::integer;
using random_pairs::Pair;
using Family = Pair (*)(Generator&);

Point noise(Generator& g, long size) {
  return {Rational(integer(g, -size, size), 64), Rational(integer(g, -size, size), 64),
          Rational(integer(g, -size, size), 64)};
}

/// Patch (a,b), a and b in {0,1}, of a quadratic B-spline surface over a uniform grid.
class Quilt {
 public:
  Quilt(Generator& g, long size) {
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b) grid_[a][b] = Point{Rational(a), Rational(b), Rational(0)} + noise(g, size);
  }
  BezierPatch patch(int a, int b) const {
    std::array<std::array<Point, 3>, 3> rows;
    for (int i = 0; i < 3; ++i) rows[i] = piece({grid_[a + i][b], grid_[a + i][b + 1], grid_[a + i][b + 2]});
    ControlNet net;
    for (int j = 0; j < 3; ++j) {
      const auto column = piece({rows[0][j], rows[1][j], rows[2][j]});
      for (int i = 0; i < 3; ++i) net[i][j] = column[i];
    }
    return BezierPatch(net);
  }

 private:
  static std::array<Point, 3> piece(const std::array<Point, 3>& p) {
    const Rational half(1, 2);
    return {half * (p[0] + p[1]), p[1], half * (p[1] + p[2])};
  }
  std::array<std::array<Point, 4>, 4> grid_;
};

BezierPatch turned(Generator& g, BezierPatch patch) {
  if (integer(g, 0, 1) == 1) patch = patch.exchanged();
  if (integer(g, 0, 1) == 1) patch = patch.reversed_first();
  if (integer(g, 0, 1) == 1) patch = patch.reversed_second();
  return patch;
}

/// In any position in space and in their parameters.
Pair placed(Generator& g, const BezierPatch& x, const BezierPatch& y) {
  const random_pairs::AffineMap map = random_pairs::affine_map(g);
  return {turned(g, map(x)), turned(g, map(y))};
}

Pair smooth_sides(Generator& g) {
  const Quilt quilt(g, integer(g, 0, 24));
  return placed(g, quilt.patch(0, 0), quilt.patch(0, 1));
}
Pair smooth_corners(Generator& g) {
  const Quilt quilt(g, integer(g, 0, 24));
  return placed(g, quilt.patch(0, 1), quilt.patch(1, 0));
}

Point any_lift(Generator& g) { return {Rational(integer(g, -3, 4), 4), 0, Rational(integer(g, -4, 4), 4)}; }

/// y begins at the side u = 1 of x.
Pair bent_sides(Generator& g) {
  const BezierPatch x = Quilt(g, 12).patch(0, 0);
  const Point lift = any_lift(g);
  ControlNet net;
  for (std::size_t j = 0; j < 3; ++j) {
    net[0][j] = x.net()[2][j];
    net[1][j] = net[0][j] + Rational(1, 2) * lift + noise(g, 6);
    net[2][j] = net[0][j] + lift + noise(g, 6);
  }
  return placed(g, x, BezierPatch(net));
}

/// y begins at the corner u = v = 1 of x.
Pair bent_corners(Generator& g) {
  const BezierPatch x = Quilt(g, 12).patch(0, 0);
  const Point lift = any_lift(g);
  const Point along = any_lift(g) + Point{0, Rational(1, 2), 0};
  ControlNet net;
  for (long i = 0; i < 3; ++i)
    for (long j = 0; j < 3; ++j)
      net[i][j] = x.net()[2][2] + Rational(i, 2) * lift + Rational(j, 2) * along +
                  (i + j > 0 ? noise(g, 4) : Point{0, 0, 0});
  return placed(g, x, BezierPatch(net));
}

/// y begins at the side u = 1 of x, or in a corner of it, rises, and comes down through x.
Pair returning(Generator& g, bool corner) {
  const BezierPatch x = Quilt(g, 8).patch(0, 0);
  ControlNet net;
  for (std::size_t j = 0; j < 3; ++j) {
    const Point away = {Rational(corner ? 2 * static_cast<long>(j) : 0, 4), 0, 0};
    net[0][j] = x.net()[2][corner ? 0 : j] + away + (corner && j > 0 ? noise(g, 4) : Point{0, 0, 0});
    net[1][j] = net[0][j] + Point{0, Rational(corner ? 1 : 0, 2), Rational(3, 4)} + noise(g, 8);
    net[2][j] = x.net()[0][j] + Point{Rational(corner ? 1 : 0, 2), 0, Rational(-1, 2)} + noise(g, 8);
  }
  return placed(g, x, BezierPatch(net));
}
Pair returning_sides(Generator& g) { return returning(g, false); }
Pair returning_corners(Generator& g) { return returning(g, true); }

/// Parts of one patch: the surfaces are the same.
Pair parts(Generator& g) {
  const BezierPatch whole = Quilt(g, 20).patch(0, 0);
  const Rational u(integer(g, 1, 7), 8);
  const Rational v(integer(g, 1, 7), 8);
  const BezierPatch x = whole.restricted_to(0, u, 0, v);
  return placed(g, x,
                integer(g, 0, 1) == 1 ? whole.restricted_to(u, 1, 0, v) : whole.restricted_to(u, 1, v, 1));
}

struct Counts {
  std::uint64_t decided = 0;
  std::uint64_t exactly_incomplete = 0;  // and decided in doubles
};

/// If doubles decide the pair, the graph is sound, and that of the exact solution, if that is complete.
void compare(const Pair& pair, Counts& counts) {
  const auto filtered = intersect_filtered(pair.x, pair.y, {});
  if (!filtered) return;
  ++counts.decided;
  CHECK(filtered->status == Status::complete);
  CHECK(unsound(pair.x, pair.y, *filtered) == "");
  const IntersectResult exact = intersect_exactly(pair.x, pair.y, {});
  if (exact.status == Status::complete)
    CHECK(difference(filtered->graph, exact.graph, {}) == "");
  else
    ++counts.exactly_incomplete;
}

/// `most_incomplete`: where the tangent vanishes in an irrational point of a common side.
void check_family(Family family, std::uint64_t first_seed, std::uint64_t count, std::uint64_t least_decided,
                  std::uint64_t most_incomplete = 0) {
  Counts counts;
  for (std::uint64_t seed = first_seed; seed < first_seed + count; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    compare(family(generator), counts);
  }
  CHECK(counts.decided >= least_decided);
  CHECK(counts.exactly_incomplete <= most_incomplete);
}

}  // namespace

TEST_CASE("filter contact: agrees with the exact solution on neighbours") {
  check_family(smooth_sides, 1, 4, 4);
  check_family(smooth_corners, 1, 4, 4);
  check_family(bent_sides, 1, 6, 4);
  check_family(bent_corners, 1, 6, 4);
  check_family(parts, 1, 4, 4);
  check_family(returning_sides, 1, 4, 3);
  check_family(returning_corners, 1, 4, 3);
}

TEST_CASE("filter contact: agrees with the exact solution on hundreds of neighbours", "[.slow]") {
  check_family(smooth_sides, 100, 100, 98);
  check_family(smooth_corners, 100, 100, 98);
  check_family(bent_sides, 100, 100, 75, 5);
  check_family(bent_corners, 100, 100, 50);
  check_family(parts, 100, 100, 98);
  check_family(returning_sides, 100, 50, 35);
  check_family(returning_corners, 100, 50, 35);
}

TEST_CASE("filter contact: a common side is found from all sides and directions") {
  Generator g(11);
  const Quilt quilt(g, 12);
  const BezierPatch x = quilt.patch(0, 0);
  const BezierPatch y = quilt.patch(0, 1);
  std::set<std::string> found;
  for (int turn = 0; turn < 64; ++turn) {
    const auto turned = [&](BezierPatch patch, int bits) {
      if (bits & 1) patch = patch.exchanged();
      if (bits & 2) patch = patch.reversed_first();
      return bits & 4 ? patch.reversed_second() : patch;
    };
    const BezierPatch a = turned(x, turn % 8);
    const BezierPatch b = turned(y, turn / 8);
    const auto pair = filter::make_pair(a, b);
    const auto contacts = filter::find_contacts(a, b, *pair);
    REQUIRE(contacts);
    CHECK(contacts->corners.empty());
    REQUIRE(contacts->sides.size() == 1);
    const filter::SideContact& side = contacts->sides[0];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = side.x.index(0, k);
      const std::size_t j = side.y.index(0, k);
      CHECK(a.net()[i / 3][i % 3] == b.net()[j / 3][j % 3]);
    }
    const auto result = intersect_filtered(a, b, {});
    REQUIRE(result);
    if (turn % 9 == 0) CHECK(unsound(a, b, *result) == "");
    CHECK(result->graph.arcs.size() == 1);
    for (const Node& node : result->graph.nodes) {
      std::string on;
      for (const Side& s : node.on) on += std::string(name(s.parameter)) + (s.value == 1 ? "1" : "0");
      found.insert(on);
    }
  }
  CHECK(found.size() == 16);
}

TEST_CASE("filter contact: edges that are smooth but for rounding") {
  constexpr unsigned seed = 11;
  INFO("seed " << seed);
  Generator g(seed);
  for (int i = 0; i < 21; ++i) {
    const Quilt quilt(g, 12);
    const BezierPatch x = quilt.patch(0, 0);
    const BezierPatch smooth = quilt.patch(1, 0);
    const auto exactly = intersect_filtered(x, smooth, {});
    REQUIRE(exactly);
    REQUIRE(exactly->graph.arcs.size() == 1);
    CHECK(exactly->graph.arcs[0].contact == Contact::tangential);
    ControlNet net = smooth.net();  // tilted by 2^-60, at the other end too, downwards or upwards, or not
    net[1][0][2] += power_of_two(-60);
    net[1][2][2] += Rational(i % 3 - 1) * power_of_two(-60);
    const auto nearly = intersect_filtered(x, BezierPatch(net), {});
    REQUIRE(nearly);
    CHECK(nearly->status == Status::complete);
    REQUIRE(nearly->graph.arcs.size() == 1);
    CHECK(nearly->graph.arcs[0].contact == Contact::transversal);
  }
}

TEST_CASE("filter contact: a second meeting is not overlooked") {
  Generator g(5);
  for (int i = 0; i < 20; ++i) {
    INFO("pair " << i);
    const BezierPatch x = Quilt(g, 8).patch(0, 0);
    // y starts at the side v = 1 of x, and comes back to a point of x inside.
    const Rational u(integer(g, 1, 7), 8);
    const Rational v(integer(g, 1, 6), 8);
    ControlNet net = x.exchanged().reversed_first().net();
    for (std::size_t k = 0; k < 3; ++k) {
      net[1][k] = net[0][k] + Point{0, 0, Rational(integer(g, 2, 6), 4)} + noise(g, 8);
      net[2][k] = x(u, v) + noise(g, 16);
    }
    net[2][1] = Rational(2) * x(u, v) - Rational(1, 2) * (net[2][0] + net[2][2]);
    const BezierPatch y(net);
    REQUIRE(y(1, Rational(1, 2)) == x(u, v));
    const auto pair = filter::make_pair(x, y);
    const auto contacts = filter::find_contacts(x, y, *pair);
    REQUIRE(contacts);
    CHECK(contacts->sides.size() == 1);
    filter::Trees trees{filter::PatchTree(pair->x), filter::PatchTree(pair->y)};
    long boxes = 0;
    CHECK_FALSE(filter::meet_in_contacts_only(*pair, trees, *contacts, boxes));
  }
}

TEST_CASE("filter contact: a side that turns back on the other patch is not decided") {
  Generator g(8);
  const BezierPatch x = Quilt(g, 8).patch(0, 0);
  // On the same side of a common tangent plane.
  ControlNet net = x.net();
  for (std::size_t k = 0; k < 3; ++k) net[2][k] = net[2][k] + Point{0, 0, Rational(1, 8)};
  CHECK_FALSE(intersect_filtered(x, BezierPatch(net), {}));
}

TEST_CASE("filter contact: corners that agree but for rounding are left to the exact solution") {
  Generator g(9);
  const Quilt quilt(g, 8);
  const BezierPatch x = quilt.patch(0, 0);
  for (const auto& [row, column] : {std::pair<int, int>{1, 1}, {0, 1}}) {
    const BezierPatch y = quilt.patch(row, column);
    REQUIRE(intersect_filtered(x, y, {}));
    ControlNet net = y.net();
    net[0][0][2] += power_of_two(-200);
    CHECK_FALSE(intersect_filtered(x, BezierPatch(net), {}));
  }
}

}  // namespace exsect::contact_test
