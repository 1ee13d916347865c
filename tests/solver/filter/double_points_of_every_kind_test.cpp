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
#include "support/power_nets.h"
#include "support/random_nets.h"

namespace exsect::double_points_of_every_kind_test {
namespace {

using random_nets::image;
using random_nets::ProjectiveMap;
using random_pairs::Generator;
using random_pairs::integer;
using testing::Terms;

Rational sixteenths(Generator& generator, long largest) {
  return Rational(integer(generator, -largest, largest), 16);
}
Terms times(const Rational& factor, const Terms& h) { return Terms{{{0, 0}, factor}} * h; }
Terms linear(const Rational& c, const Rational& a, const Rational& b) {
  return Terms{{{0, 0}, c}, {{1, 0}, a}, {{0, 1}, b}};
}

/// The graphs of f + h over [0,1]^2 and of f over a larger parallelogram: they meet over h = 0.
struct Heights {
  RationalPatch x;
  RationalPatch y;
  RationalPatch difference;        // the graph of h over [0,1]^2
  std::array<Rational, 4> centre;  // a singular point of h
};

/// (X,Y) = (1/2,1/2) + (p (r - 1/2) - q (s - 1/2), q (r - 1/2) + p (s - 1/2)) on the second patch. Requires f
/// of total degree `degree` at most. Where q = 0 the parameters u and r turn together.
Heights heights(const Terms& f, const Terms& h, int degree, const Rational& p, const Rational& q,
                const std::array<Rational, 2>& at) {
  const Rational half(1, 2);
  const Terms first = linear(half - half * p + half * q, p, -q);
  const Terms second = linear(half - half * p - half * q, q, p);
  Terms turned;
  for (const auto& [i, value] : f) {
    Terms product{{{0, 0}, value}};
    for (std::size_t k = 0; k < i.first; ++k) product = product * first;
    for (std::size_t k = 0; k < i.second; ++k) product = product * second;
    turned = turned + product;
  }
  const Terms a = linear(0, 1, 0);
  const Terms b = linear(0, 0, 1);
  const Rational da = at[0] - half;
  const Rational db = at[1] - half;
  const Rational size = p * p + q * q;
  return {testing::power_patch({a, b, f + h}, degree),
          testing::power_patch({first, second, turned}, degree),
          testing::power_patch({a, b, h}, degree),
          {at[0], at[1], half + (p * da + q * db) / size, half + (p * db - q * da) / size}};
}

/// h begins with a definite (sign 1) or an indefinite form about a rational point; `moved` is added to it.
Heights with_double_point(Generator& generator, int sign, int degree, const Rational& moved = 0) {
  const Rational a = Rational(1, 2) + sixteenths(generator, 3);
  const Rational b = Rational(1, 2) + sixteenths(generator, 3);
  const Rational slope(2 * integer(generator, -4, 3) + 1, 16);
  const Terms first = linear(-a - slope * b, 1, slope);
  const Terms second = linear(-b + slope * a, -slope, 1);
  Terms h = first * first + times(Rational(sign * integer(generator, 4, 15), 16), second * second);
  if (degree == 3)
    h = h + times(sixteenths(generator, 6), first * first * first) +
        times(sixteenths(generator, 6), first * second * second);
  h[{0, 0}] += moved;
  Terms f;
  const auto most = static_cast<std::size_t>(degree);
  for (std::size_t i = 0; i <= most; ++i)
    for (std::size_t j = 0; i + j <= most; ++j) f[{i, j}] = sixteenths(generator, 3);
  return heights(f, h, degree, Rational(3, 2), Rational(2 * integer(generator, -2, 1) + 1, 8), {a, b});
}

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
