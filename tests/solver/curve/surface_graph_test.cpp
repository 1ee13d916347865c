// Graphs of surfaces and patches: kinds, places and polylines of what the curve's graph says.
#include "curve/surface_graph.h"

#include <cmath>

#include "support/catch.h"

namespace exsect::surface_graph_test {
namespace {

/// The square as a plate at z = 0, which the planes and quadrics below cut.
const RationalPatch square({{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}}});

SurfaceCurve curve_of(BivariatePolynomial section) {
  SurfaceCurve result;
  result.section = std::move(section);
  result.graph = curve_graph(result.section);
  return result;
}

BivariatePolynomial number(const Rational& q) { return BivariatePolynomial::constant(q); }
const BivariatePolynomial u = BivariatePolynomial::r(), v = BivariatePolynomial::s();

BivariatePolynomial circle(const Rational& squared_radius) {
  const BivariatePolynomial x = u - number(Rational(1, 2)), y = v - number(Rational(1, 2));
  return x * x + y * y - number(squared_radius);
}

}  // namespace

TEST_CASE("surface graph: a circle turns twice, and its chords keep within the tolerance") {
  const DrawnPatch patch(square);
  const GraphBuilder graph = surface_graph(curve_of(circle(Rational(1, 9))), patch, 1e-3);
  REQUIRE(graph.nodes().size() == 2);
  for (const Node& node : graph.nodes()) {
    CHECK(node.kinds == std::vector{NodeKind::turning});
    CHECK(node.wrt == std::vector{Parameter::u});
  }
  REQUIRE(graph.arcs().size() == 2);
  for (const Arc& arc : graph.arcs()) {
    CHECK(arc.contact == Contact::transversal);
    CHECK(arc.place == ArcPlace::interior);
    CHECK(arc.error_bound <= 1e-3);
    for (const PolylineVertex& vertex : arc.polyline)
      CHECK(std::fabs(std::hypot(vertex.point[0] - 0.5, vertex.point[1] - 0.5) - 1.0 / 3) <= 1e-3);
  }
}

// Next to such a point v changes as a root of the change of u: 1e-6 in v are 1e-18, or 1e-30, in u.
TEST_CASE("surface graph: vertical tangents inside arcs") {
  const DrawnPatch patch(square);
  const BivariatePolynomial x = u - number(Rational(2, 3)), y = v - number(Rational(1, 3));
  for (const bool fifth : {false, true})
    for (const bool falls : {false, true})
      for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
        const BivariatePolynomial power = fifth ? y * y * y * y * y : y * y * y;
        const GraphBuilder graph =
            surface_graph(curve_of(falls ? power + x : power - x * (x + number(2))), patch, tolerance);
        REQUIRE(graph.arcs().size() == 1);
        CHECK(graph.arcs()[0].error_bound <= tolerance);
        for (const PolylineVertex& vertex : graph.arcs()[0].polyline) {
          const double off = vertex.point[1] - 1.0 / 3, along = vertex.point[0] - 2.0 / 3;
          const double right = falls ? -along : along * (along + 2);
          CHECK(std::fabs(off - std::copysign(std::pow(std::fabs(right), fifth ? 0.2 : 1.0 / 3), right)) <
                tolerance + 1e-3);
        }
      }
}

TEST_CASE("surface graph: singular points have the kinds of docs/formats.md") {
  const DrawnPatch patch(square);
  const auto kinds_at = [&](const BivariatePolynomial& section, double at) {
    const GraphBuilder graph = surface_graph(curve_of(section), patch, 1e-3);
    for (const Node& node : graph.nodes())
      if (node.approx[0] == at && node.approx[1] == at) return node.kinds;
    return std::vector<NodeKind>{};
  };
  const auto shifted = [](const BivariatePolynomial& w) { return w - number(Rational(1, 2)); };
  const BivariatePolynomial a = shifted(u), b = shifted(v);
  using enum NodeKind;
  CHECK(kinds_at(a * a - b * b, 0.5) == std::vector{crossing});
  CHECK(kinds_at(a * a - b * b * b, 0.5) == std::vector{cusp});
  CHECK(kinds_at(a * a + b * b, 0.5) == std::vector{touch});
  // In the corner one of two branches, both branches of a cusp, and none.
  CHECK(kinds_at(u * u - v * v, 0) == std::vector{boundary, corner, crossing});
  CHECK(kinds_at((u - v) * (u - v) - u * u * u, 0) == std::vector{boundary, corner, crossing});
  CHECK(kinds_at(u * u + v * v, 0) == std::vector{boundary, corner, touch});
}

TEST_CASE("surface graph: contact, sides and isolated points") {
  const DrawnPatch patch(square);
  const GraphBuilder line = surface_graph(curve_of((u - v) * (u - v)), patch, 1e-3);
  REQUIRE(line.arcs().size() == 1);
  CHECK(line.arcs()[0].contact == Contact::tangential);
  for (const Node& node : line.nodes())
    CHECK(node.kinds == std::vector{NodeKind::boundary, NodeKind::corner});
  for (const BivariatePolynomial& side : {u, v, u - number(1), v - number(1)}) {
    const GraphBuilder graph = surface_graph(curve_of(side), patch, 1e-3);
    REQUIRE(graph.arcs().size() == 1);
    CHECK(graph.arcs()[0].place == ArcPlace::patch_boundary);
  }
  const GraphBuilder point = surface_graph(curve_of(circle(0)), patch, 1e-3);
  REQUIRE(point.isolated_points().size() == 1);
  CHECK(point.nodes()[0].kinds == std::vector{NodeKind::touch});
  CHECK(point.nodes()[0].around == 1);
  const GraphBuilder cross = surface_graph(curve_of(u * u - v * v - u + v), patch, 1e-3);  // u = v, u = 1 - v
  CHECK(cross.arcs().size() == 4);
  CHECK(std::ranges::count_if(cross.nodes(), [](const Node& node) {
          return node.kinds == std::vector{NodeKind::crossing};
        }) == 1);
}

}  // namespace exsect::surface_graph_test
