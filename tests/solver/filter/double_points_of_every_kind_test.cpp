// Touch points and crossings of cubic and of weighted patches: against the plane curve in which the
// difference of two heights vanishes, against biquadratic pairs, and under maps that rename only.
#include <exsect/geometry/implicit_surface.h>
#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/intersect_surface.h>

#include <algorithm>
#include <cmath>

#include "filter/filter.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/height_pairs.h"
#include "support/random_nets.h"

namespace exsect::double_points_of_every_kind_test {
namespace {

using height_pairs::Generator;
using height_pairs::Heights;
using height_pairs::with_double_point;
using random_nets::image;
using random_nets::ProjectiveMap;

/// What a graph is like, whatever its parameters are.
struct Counts {
  int open, closed, branched, isolated, crossings, ends;
  bool operator==(const Counts&) const = default;
};
Counts counts(const IntersectionGraph& graph) {
  const auto of_kind = [&](NodeKind kind) {
    return static_cast<int>(std::count_if(graph.nodes.begin(), graph.nodes.end(), [&](const Node& node) {
      return std::count(node.kinds.begin(), node.kinds.end(), kind) > 0;
    }));
  };
  return {graph.count(ComponentShape::open),     graph.count(ComponentShape::closed),
          graph.count(ComponentShape::branched), static_cast<int>(graph.isolated_points.size()),
          of_kind(NodeKind::crossing),           graph.boundary_points()};
}
/// By the exact plane curve.
Counts expected_counts(const Heights& pair) {
  const IntersectResult result =
      intersect(ImplicitSurface::plane({0, 0, 0}, {0, 0, 1}), pair.difference, IntersectOptions{});
  CHECK(result.status == Status::complete);
  return counts(result.graph);
}

double distance(const Point& p, const std::array<double, 3>& q) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += std::pow(to_double(p[k] - from_double(q[k])), 2);
  return std::sqrt(sum);
}

/// Vertices are on both patches within the arc's bound.
void check_vertices(const RationalPatch& x, const RationalPatch& y, const IntersectionGraph& graph) {
  for (const Arc& arc : graph.arcs) {
    CHECK(arc.error_bound > 0);
    const std::size_t step = std::max<std::size_t>(1, arc.polyline.size() / 6);
    for (std::size_t i = 0; i < arc.polyline.size(); i += step) {
      const auto& [w, p] = arc.polyline[i];
      const double rounding = 1e-13 * (1 + distance({0, 0, 0}, p));
      CHECK(distance(x(from_double(w[0]), from_double(w[1])), p) <= 2 * arc.error_bound + rounding);
      CHECK(distance(y(from_double(w[2]), from_double(w[3])), p) <= 2 * arc.error_bound + rounding);
    }
  }
}

bool has_node_at(const IntersectionGraph& graph, const std::array<Rational, 4>& at) {
  return std::any_of(graph.nodes.begin(), graph.nodes.end(), [&](const Node& node) {
    bool is_there = node.kinds == std::vector<NodeKind>{NodeKind::touch} ||
                    node.kinds == std::vector<NodeKind>{NodeKind::crossing};
    for (std::size_t j = 0; j < 4; ++j)
      is_there = is_there && node.box[j].lower == at[j] && node.box[j].upper == at[j];
    return is_there;
  });
}

/// True if the pair is complete; then it has the double point and is what the plane curve is.
bool is_right(const Heights& pair) {
  const IntersectResult result = intersect(pair.x, pair.y);
  if (result.status != Status::complete) return false;
  CHECK(counts(result.graph) == expected_counts(pair));
  CHECK(has_node_at(result.graph, pair.centre));
  check_vertices(pair.x, pair.y, result.graph);
  return true;
}

/// Of a point from the segment.
double distance(const std::array<double, 3>& p, const std::array<double, 3>& a,
                const std::array<double, 3>& b) {
  double along = 0;
  double length = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    along += (p[k] - a[k]) * (b[k] - a[k]);
    length += (b[k] - a[k]) * (b[k] - a[k]);
  }
  const double t = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += std::pow(p[k] - a[k] - t * (b[k] - a[k]), 2);
  return std::sqrt(sum);
}

using Vector3 = std::array<double, 3>;
double determinant(const Vector3& a, const Vector3& b, const Vector3& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
         c[0] * (a[1] * b[2] - a[2] * b[1]);
}

/// The point of the curve with this parameter `axis`, by Newton's method with differences.
Vector3 on_curve(const RationalPatch& x, const RationalPatch& y, std::array<double, 4> w, std::size_t axis) {
  const auto difference = [&](const std::array<double, 4>& at) {
    const Point d = x(from_double(at[0]), from_double(at[1])) - y(from_double(at[2]), from_double(at[3]));
    return Vector3{to_double(d[0]), to_double(d[1]), to_double(d[2])};
  };
  for (int step = 0; step < 8; ++step) {
    const Vector3 value = difference(w);
    std::array<Vector3, 3> column;
    for (std::size_t i = 0; i < 3; ++i) {
      auto moved = w;
      moved[i < axis ? i : i + 1] += 0x1p-24;
      column[i] = difference(moved);
      for (std::size_t k = 0; k < 3; ++k) column[i][k] = (column[i][k] - value[k]) * 0x1p24;
    }
    const double all = determinant(column[0], column[1], column[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      auto replaced = column;
      replaced[i] = value;
      w[i < axis ? i : i + 1] -= determinant(replaced[0], replaced[1], replaced[2]) / all;
    }
  }
  const Point p = x(from_double(w[0]), from_double(w[1]));
  return {to_double(p[0]), to_double(p[1]), to_double(p[2])};
}

/// Points of the curve near the middles of the chords next to nodes are as near to the chords as the bound
/// says.
void check_chords(const RationalPatch& x, const RationalPatch& y, const IntersectionGraph& graph) {
  for (const Arc& arc : graph.arcs)
    for (std::size_t i = 0; i + 1 < arc.polyline.size(); ++i) {
      if (i >= 3 && i + 4 < arc.polyline.size()) continue;
      const PolylineVertex& from = arc.polyline[i];
      const PolylineVertex& to = arc.polyline[i + 1];
      std::array<double, 4> middle;
      std::size_t axis = 0;
      for (std::size_t j = 0; j < 4; ++j) {
        middle[j] = 0.5 * (from.parameters[j] + to.parameters[j]);
        const auto size = [&](std::size_t k) { return std::fabs(to.parameters[k] - from.parameters[k]); };
        if (size(j) > size(axis)) axis = j;
      }
      const Vector3 point = on_curve(x, y, middle, axis);
      CHECK(distance(point, from.point, to.point) <= arc.error_bound);
    }
}

ProjectiveMap affine(const Rational& by, const Point& shift) {
  return {{{by, 0, 0, shift[0]}, {0, by, 0, shift[1]}, {0, 0, by, shift[2]}, {0, 0, 0, 1}}};
}
/// By rational angles about two axes.
ProjectiveMap rotation() {
  const Rational c(3, 5), s(4, 5), d(12, 13), e(5, 13);
  return {{{c, -s * d, s * e, 0}, {s, c * d, -c * e, 0}, {0, e, d, 0}, {0, 0, 0, 1}}};
}

/// The graph of the images is that of the patches.
void check_images(const Heights& pair, const ProjectiveMap& map) {
  const IntersectResult expected = intersect(pair.x, pair.y);
  const RationalPatch x = image(pair.x, map);
  const RationalPatch y = image(pair.y, map);
  const IntersectResult result = intersect(x, y);
  REQUIRE(expected.status == Status::complete);
  REQUIRE(result.status == Status::complete);
  CHECK(difference(expected.graph, result.graph, {}) == "");
  CHECK(has_node_at(result.graph, pair.centre));
  check_vertices(x, y, result.graph);
}

}  // namespace

TEST_CASE("filter double points of every kind: cubic heights") {
  int decided = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    decided += is_right(with_double_point(generator, 1, 3)) ? 1 : 0;
    decided += is_right(with_double_point(generator, -1, 3)) ? 1 : 0;
  }
  CHECK(decided >= 18);
}

TEST_CASE("filter double points of every kind: biquadratic pairs as bicubic ones") {
  int decided = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Heights pair = with_double_point(generator, seed % 2 == 0 ? 1 : -1, 2);
    const IntersectResult expected = intersect(pair.x, pair.y);
    const IntersectResult result = intersect_in_doubles(pair.x, pair.y, {});
    REQUIRE(expected.status == Status::complete);
    if (result.status != Status::complete) continue;
    ++decided;
    CHECK(difference(expected.graph, result.graph, {}) == "");
  }
  CHECK(decided >= 7);
}

TEST_CASE("filter double points of every kind: two of them") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    for (const int factor : {1, -1}) {
      INFO("seed " << seed << ", factor " << factor);
      Generator generator(seed);
      Heights pair = height_pairs::with_two_double_points(generator, factor);
      const IntersectResult expected = intersect(pair.x, pair.y);
      REQUIRE(expected.status == Status::complete);
      const IntersectResult elevated = intersect_in_doubles(pair.x, pair.y, {});
      CHECK(elevated.status == Status::complete);
      CHECK(difference(expected.graph, elevated.graph, {}) == "");
      const auto map = random_nets::projective_map(generator);
      const IntersectResult result = intersect(image(pair.x, map), image(pair.y, map));
      CHECK(result.status == Status::complete);
      CHECK(difference(expected.graph, result.graph, {}) == "");
      CHECK(has_node_at(result.graph, pair.centre));
    }
  }
}

TEST_CASE("filter double points of every kind: polylines keep to the curve on the way to a crossing") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    Heights pair = with_double_point(generator, -1, seed % 2 == 0 ? 2 : 3);
    const auto map = random_nets::projective_map(generator);
    const RationalPatch x = seed <= 2 ? pair.x : image(pair.x, map);
    const RationalPatch y = seed <= 2 ? pair.y : image(pair.y, map);
    IntersectOptions options;
    for (const double tolerance : {1e-4, 1e-7}) {
      options.tolerance = tolerance;
      const IntersectResult result = intersect_in_doubles(x, y, options);
      REQUIRE(result.status == Status::complete);
      check_chords(x, y, result.graph);
    }
  }
}

TEST_CASE("filter double points of every kind: a touch point beside a curve") {
  using height_pairs::linear;
  for (const Rational& away : {Rational(1, 4), Rational(1, 8)}) {
    INFO("away " << away);
    const Rational half(1, 2);
    const auto a = linear(-half, 1, 0);
    const auto b = linear(-half, 0, 1);
    const auto h = (a * a + b * b) * linear(-half - away, 1, Rational(1, 16));
    CHECK(is_right(height_pairs::heights(a * b, h, 3, Rational(3, 2), Rational(1, 8), {half, half})));
  }
}

TEST_CASE("filter double points of every kind: one in a field of degree nine has its reason") {
  // Over (1/2,1/3), where (X,Y) is 9/8 (r³,s³) on the second patch, less 1/16.
  using height_pairs::linear;
  using height_pairs::times;
  for (const int sign : {1, -1}) {
    const testing::Terms a = linear(Rational(-1, 2), 1, 0);
    const testing::Terms b = linear(Rational(-1, 3), 0, 1);
    const testing::Terms h = a * a + times(Rational(sign, 2), b * b) + times(Rational(1, 4), a * a * a);
    const RationalPatch x = testing::power_patch({linear(0, 1, 0), linear(0, 0, 1), h}, 3);
    const RationalPatch y =
        testing::power_patch({testing::Terms{{{0, 0}, Rational(-1, 16)}, {{3, 0}, Rational(9, 8)}},
                              testing::Terms{{{0, 0}, Rational(-1, 16)}, {{0, 3}, Rational(9, 8)}},
                              {}},
                             3);
    const IntersectResult result = intersect(x, y);
    REQUIRE(result.status == Status::incomplete);
    CHECK(result.incomplete.at(0).reason == (sign > 0 ? Reason::tangency : Reason::crossing));
  }
}

TEST_CASE("filter double points of every kind: projective images") {
  int decided = 0;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Heights pair = with_double_point(generator, seed % 2 == 0 ? 1 : -1, seed % 4 < 2 ? 2 : 3);
    const auto map = random_nets::projective_map(generator);
    const IntersectResult expected = intersect(pair.x, pair.y);
    const RationalPatch x = image(pair.x, map);
    const RationalPatch y = image(pair.y, map);
    REQUIRE_FALSE(x.is_polynomial());
    const IntersectResult result = intersect(x, y);
    if (result.status != Status::complete || expected.status != Status::complete) continue;
    ++decided;
    CHECK(difference(expected.graph, result.graph, {}) == "");
    CHECK(has_node_at(result.graph, pair.centre));
    check_vertices(x, y, result.graph);
  }
  CHECK(decided >= 14);
}

TEST_CASE("filter double points of every kind: the patches exchanged, turned over, moved and scaled") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    Heights pair = with_double_point(generator, seed % 2 == 0 ? 1 : -1, seed < 3 ? 3 : 2);
    if (seed >= 3) {
      const auto map = random_nets::projective_map(generator);
      pair.x = image(pair.x, map);
      pair.y = image(pair.y, map);
    }
    const IntersectResult expected = intersect(pair.x, pair.y);
    REQUIRE(expected.status == Status::complete);
    const auto agrees = [&](const RationalPatch& x, const RationalPatch& y, const Renaming& renaming) {
      const IntersectResult other = intersect(x, y);
      CHECK(other.status == Status::complete);
      CHECK(difference(expected.graph, other.graph, renaming) == "");
    };
    agrees(pair.y, pair.x, {{2, 3, 0, 1}, {}});
    agrees(pair.x.transposed(), pair.y, {{1, 0, 2, 3}, {}});
    agrees(pair.x, pair.y.restricted_to(1, 0, 0, 1), {{0, 1, 2, 3}, {false, false, true, false}});
    check_images(pair, affine(Rational(127, 5), {0, 0, 0}));
    check_images(pair, affine(Rational(1, 3), {100000000, -100000000, 7}));
    check_images(pair, rotation());
  }
}

TEST_CASE("filter double points of every kind: parameters changed by a Moebius map") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    Heights pair = with_double_point(generator, seed % 2 == 0 ? 1 : -1, seed < 3 ? 2 : 3);
    const Rational k(seed % 2 == 0 ? 3 : 4, 5);
    const auto moved = [&](const Rational& t) { return Rational(k * t / (1 - t + k * t)); };
    for (const bool of_x : {true, false}) {
      Heights other = pair;
      RationalPatch& patch = of_x ? other.x : other.y;
      patch = random_nets::reparametrised(patch, k);
      Rational& t = other.centre[of_x ? 0 : 2];
      t = moved(t);
      CHECK(is_right(other));
    }
  }
}

TEST_CASE("filter double points of every kind: near them there is what the plane curve says, or no answer") {
  int decided = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    for (const int digits : {3, 6, 12, 20}) {
      Rational away = 1;
      for (int i = 0; i < digits; ++i) away /= 10;
      for (const Rational& moved : {away, Rational(-away)}) {
        INFO("seed " << seed << ", " << (moved > 0 ? "+" : "-") << "1e-" << digits);
        Generator generator(seed);
        Heights pair = with_double_point(generator, seed % 2 == 0 ? 1 : -1, seed < 3 ? 3 : 2, moved);
        const auto map = random_nets::projective_map(generator);
        if (seed >= 3) {
          pair.x = image(pair.x, map);
          pair.y = image(pair.y, map);
        }
        const IntersectResult result = intersect(pair.x, pair.y);
        if (result.status != Status::complete) {
          CHECK(digits > 6);
          CHECK(result.incomplete.at(0).reason == (seed % 2 == 0 ? Reason::tangency : Reason::crossing));
          continue;
        }
        ++decided;
        CHECK(counts(result.graph) == expected_counts(pair));
        check_vertices(pair.x, pair.y, result.graph);
      }
    }
  }
  CHECK(decided >= 16);
}

}  // namespace exsect::double_points_of_every_kind_test
