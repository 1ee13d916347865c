#include "self/cusp_arc.h"

#include <exsect/geometry/patch_file.h>
#include <exsect/solver/self_intersect.h>

#include <algorithm>
#include <cmath>

#include "support/catch.h"
#include "support/graph_patches.h"

namespace exsect::cusp_arc_test {

namespace {

/// Whitney's umbrella (a², ab, b), a = (u - c) + (v - d), b = (v - d) - 2 (u - c): the line b = 0 meets
/// itself in (c, d) ± t (1, 2), and ends in the cuspidal point (c, d).
BezierPatch umbrella(const Rational& c, const Rational& d) {
  const auto linear = [&](const Rational& p, const Rational& q) {
    return testing::Terms{{{{0, 0}, -p * c - q * d}, {{1, 0}, p}, {{0, 1}, q}}};
  };
  const testing::Terms a = linear(1, 1), b = linear(-2, 1);
  const std::array<testing::Terms, 3> coordinates = {a * a, a * b, b};
  ControlNet net{};
  for (std::size_t k = 0; k < 3; ++k)
    for (const auto& [power, value] : coordinates[k]) net[power.first][power.second][k] += value;
  return BezierPatch::from_power_basis(net);
}

/// One open arc from a cuspidal point to a side, as short as its distance from there says: `length` bounds
/// the parameters' differences along it.
void check_short_curve(const BezierPatch& patch, double length) {
  const IntersectResult result = self_intersect(patch);
  CHECK(result.status == Status::complete);
  REQUIRE(result.graph.components.size() == 1);
  REQUIRE(result.graph.arcs.size() == 1);
  CHECK(result.graph.components[0].shape == ComponentShape::open);
  for (const NodeKind kind : {NodeKind::cusp, NodeKind::boundary})
    CHECK(std::ranges::count_if(result.graph.nodes, [kind](const Node& node) {
            return std::ranges::count(node.kinds, kind) > 0;
          }) == 1);
  for (const PolylineVertex& vertex : result.graph.arcs[0].polyline)
    for (std::size_t j = 0; j < 2; ++j)
      CHECK(std::fabs(vertex.parameters[j] - vertex.parameters[j + 2]) <= length + 0x1p-50);
}

}  // namespace

TEST_CASE("a cuspidal point near a side has a short curve", "[cusp]") {
  const Rational c(3, 7);
  for (const int bits : {3, 20, 40, 60, 80, 100}) {
    INFO("2^-" << bits);
    const Rational e = power_of_two(-bits);
    for (const Rational& d : {e, Rational(1 - e)}) {
      const BezierPatch x = umbrella(c, d);
      check_short_curve(x, 2.001 * to_double(e));
      check_short_curve(bits % 40 == 0 ? x.exchanged() : x.reversed_first(), 2.001 * to_double(e));
    }
  }
  // Bent and rotated, 2^-100 from v = 1.
  check_short_curve(
      read_patches(std::string(EXSECT_CASES) + "/found/pinch-point-at-a-side.json").patches.at(0).patch,
      1e-12);
}

}  // namespace exsect::cusp_arc_test
