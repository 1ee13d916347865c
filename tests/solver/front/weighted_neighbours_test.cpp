// Weighted patches that share a side, a corner or a pole: images of polynomial ones, quarters of a cylinder
// and octants of a sphere.
#include <exsect/solver/intersect_rational.h>

#include <cmath>

#include "filter/filter.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"

namespace exsect::weighted_neighbours_test {
namespace {

using random_pairs::Generator;
using Net = std::vector<std::vector<Point>>;

/// (p, 1) -> (p, 1 + p.c).
RationalPatch image(const RationalPatch& patch, const Point& c) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (int i = 0; i <= patch.degree_u(); ++i) {
    net.emplace_back();
    for (int j = 0; j <= patch.degree_v(); ++j) {
      HomogeneousPoint p = patch.homogeneous(i, j);
      p[3] += c[0] * p[0] + c[1] * p[1] + c[2] * p[2];
      net.back().push_back(p);
    }
  }
  return RationalPatch::from_homogeneous(net);
}

/// t -> t / (t + k (1 - t)) in the second parameter.
RationalPatch reparametrised(const RationalPatch& patch, const Rational& k) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (int i = 0; i <= patch.degree_u(); ++i) {
    net.emplace_back();
    Rational factor = 1;
    for (int j = 0; j <= patch.degree_v(); ++j) {
      HomogeneousPoint p = patch.homogeneous(i, j);
      for (Rational& c : p) c *= factor;
      net.back().push_back(p);
      factor *= k;
    }
  }
  return RationalPatch::from_homogeneous(net);
}

/// Patches (a,b) of degree n of a sheet over [0,2]^2 with four of them.
std::vector<std::vector<RationalPatch>> sheet(Generator& generator, std::size_t n) {
  Net points(2 * n + 1);
  for (std::size_t i = 0; i <= 2 * n; ++i)
    for (std::size_t j = 0; j <= 2 * n; ++j)
      points[i].push_back({Rational(static_cast<long>(i), static_cast<long>(n)),
                           Rational(static_cast<long>(j), static_cast<long>(n)),
                           Rational(random_pairs::integer(generator, -8, 8), 64)});
  std::vector<std::vector<RationalPatch>> result(2);
  for (std::size_t a = 0; a < 2; ++a)
    for (std::size_t b = 0; b < 2; ++b) {
      Net net(n + 1);
      for (std::size_t i = 0; i <= n; ++i)
        for (std::size_t j = 0; j <= n; ++j) net[i].push_back(points[n * a + i][n * b + j]);
      result[a].emplace_back(net);
    }
  return result;
}

/// The octant of the unit sphere over this quadrant: circles about the z axis, the first parameter from the
/// pole.
RationalPatch octant(int quadrant) {
  const auto turned = [&](Rational x, Rational y) {
    for (int k = 0; k < quadrant; ++k) std::tie(x, y) = std::pair<Rational, Rational>(-y, x);
    return std::array<Rational, 2>{x, y};
  };
  // Quarter circles with the homogeneous vectors (1,0,1), (1,1,1), (0,2,2).
  const std::array<std::array<long, 3>, 3> quarter = {{{1, 0, 1}, {1, 1, 1}, {0, 2, 2}}};
  std::vector<std::vector<HomogeneousPoint>> net(3);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const auto [height, radius, w] = quarter[i];
      const auto [x, y, v] = quarter[j];
      const auto xy = turned(radius * x, radius * y);
      net[i].push_back({xy[0], xy[1], Rational(height * v), Rational(w * v)});
    }
  return RationalPatch::from_homogeneous(net);
}

}  // namespace

TEST_CASE("weighted neighbours: a projective image of a sheet has its common sides and corners") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const auto patches = sheet(generator, seed % 2 == 0 ? 2 : 3);
    const Point c = {Rational(1, 4), Rational(-1, 8), Rational(1, 3)};
    const auto agrees = [&](const RationalPatch& x, const RationalPatch& y) {
      const IntersectResult expected = intersect(x, y);
      const IntersectResult result = intersect(image(x, c), image(y, c));
      REQUIRE(expected.status == Status::complete);
      REQUIRE(result.status == Status::complete);
      CHECK(difference(expected.graph, result.graph, {}) == "");
      for (const Arc& arc : result.graph.arcs)
        for (const PolylineVertex& vertex : arc.polyline) {
          const auto& w = vertex.parameters;
          const Point p = image(y, c)(from_double(w[2]), from_double(w[3]));
          for (std::size_t k = 0; k < 3; ++k)
            CHECK(std::abs(to_double(p[k]) - vertex.point[k]) <= arc.error_bound);
        }
    };
    agrees(patches[0][0], patches[1][0]);
    agrees(patches[0][0], patches[0][1].transposed());
    agrees(patches[0][0], patches[1][0].restricted_to(1, 0, 1, 0));
    agrees(patches[0][0], patches[1][1]);
  }
}

TEST_CASE("weighted neighbours: sides with different parameters") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const auto patches = sheet(generator, seed % 2 == 0 ? 2 : 3);
    const RationalPatch y = reparametrised(patches[1][0], Rational(3, 2));
    const IntersectResult result = intersect(patches[0][0], y);
    REQUIRE(result.status == Status::complete);
    REQUIRE(result.graph.arcs.size() == 1);
    CHECK(result.graph.arcs[0].place == ArcPlace::patch_boundary);
    for (const PolylineVertex& vertex : result.graph.arcs[0].polyline) {
      const Point p = y(from_double(vertex.parameters[2]), from_double(vertex.parameters[3]));
      for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(to_double(p[k]) - vertex.point[k]) <= 1e-12);
    }
    // One vector of the side moved by 2^-60: no common side any more.
    std::vector<std::vector<HomogeneousPoint>> net;
    for (int i = 0; i <= y.degree_u(); ++i) {
      net.emplace_back();
      for (int j = 0; j <= y.degree_v(); ++j) net.back().push_back(y.homogeneous(i, j));
    }
    net[0][1][2] += power_of_two(-60);
    const IntersectResult moved = intersect(patches[0][0], RationalPatch::from_homogeneous(net));
    // Of bidegree (2,2) it is an image of a polynomial pair.
    CHECK(moved.status == (seed % 2 == 0 ? Status::complete : Status::incomplete));
    for (const Arc& arc : moved.graph.arcs) CHECK(arc.place == ArcPlace::interior);
  }
}

TEST_CASE("weighted neighbours: octants of a sphere meet along meridians, and in the pole") {
  for (const int i : {1, 2, 3}) {
    INFO("octant " << i);
    const IntersectResult result = intersect(octant(0), octant(i));
    REQUIRE(result.status == Status::complete);
    if (i == 2) {
      CHECK(result.graph.isolated_points.size() == 1);
      CHECK(result.graph.nodes[0].free.size() == 2);
      continue;
    }
    REQUIRE(result.graph.arcs.size() == 1);
    CHECK(result.graph.arcs[0].contact == Contact::tangential);
    for (const PolylineVertex& vertex : result.graph.arcs[0].polyline) {
      const auto& p = vertex.point;
      CHECK(std::abs(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - 1) < 1e-12);
      CHECK(std::abs(i == 1 ? p[0] : p[1]) < 1e-12);
    }
  }
}

TEST_CASE("weighted neighbours: quarters of a cylinder, and a patch that crosses beside a common side") {
  const std::vector<std::vector<Rational>> weights = {{1, 1}, {1, 1}, {2, 2}};
  const RationalPatch first({{{1, 0, 0}, {1, 0, 2}}, {{1, 1, 0}, {1, 1, 2}}, {{0, 1, 0}, {0, 1, 2}}},
                            weights);
  const RationalPatch second({{{0, 1, 0}, {0, 1, 2}}, {{-1, 1, 0}, {-1, 1, 2}}, {{-1, 0, 0}, {-1, 0, 2}}},
                             {{2, 2}, {1, 1}, {1, 1}});
  const IntersectResult smooth = intersect(first, second);
  REQUIRE(smooth.status == Status::complete);
  REQUIRE(smooth.graph.arcs.size() == 1);
  CHECK(smooth.graph.arcs[0].contact == Contact::tangential);
  // It has the side as well, goes away from the cylinder and comes back through it.
  const RationalPatch back(
      {{{0, 1, 0}, {0, 1, 2}}, {{0, 3, 0}, {0, 3, 2}}, {{Rational(1, 2), -2, 0}, {Rational(1, 2), -2, 2}}});
  const IntersectResult crossing = intersect(first, back);
  CHECK((crossing.status == Status::incomplete || crossing.graph.arcs.size() == 2));
}

}  // namespace exsect::weighted_neighbours_test
