#include "sweep/boundary_graph.h"

#include <exsect/solver/line_patch.h>

#include "answer/model_scale.h"
#include "support/families.h"
#include "support/known_curves.h"
#include "trace/enclose.h"
#include "trace/landmark_node.h"

namespace exsect::boundary_graph_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

/// What lies on the sides of a pair without stars, as a graph.
struct Sides {
  BoundaryLines lines;
  FinishedGraph finished;
  std::vector<Incomplete> undecided;

  Sides(const BezierPatch& x, const BezierPatch& y) {
    const ModelScale scale = model_scale(x, y);
    const PairSystem<DoubleBall> system(x, y, scale.origin, scale.frame.exponent);
    lines = boundary_lines(x, y, scale, 1e-6, {});
    GraphBuilder builder;
    for (const CertifiedPoint& point : lines.points)
      builder.add_node(landmark_node(system, scale.frame, enclose<DoubleBall>(point, power_of_two(-50)),
                                     point.box(), point.sides()));
    const std::vector<StarNeighbourhood> no_stars;
    const std::vector<int> no_nodes;
    BoundaryGraph<DoubleBall> graph({x, y}, system, scale.frame, lines, no_stars, no_nodes, builder,
                                    undecided);
    graph.add_arcs();
    graph.contract();
    finished = std::move(builder).finish({{}, {}});
  }
};

}  // namespace

TEST_CASE("boundary graph: a shared side is one arc on the patches' boundary", "[sweep]") {
  const ExactCase c = families::shared_side({q(-1, 2), q(3, 2), 0});
  const Sides sides(c.x, c.y);
  CHECK(sides.undecided.empty());
  REQUIRE(sides.lines.arcs.size() == 1);
  REQUIRE(sides.finished.graph.arcs.size() == 1);
  const Arc& arc = sides.finished.graph.arcs[0];
  CHECK(arc.place == ArcPlace::patch_boundary);
  CHECK(arc.contact == Contact::transversal);
  CHECK(arc.from != arc.to);
  CHECK(arc.error_bound >= sides.lines.arcs[0].error_bound);
}

TEST_CASE("boundary graph: sheets that continue each other touch along their side", "[sweep]") {
  const ExactCase c = families::smooth_neighbour(1);
  const Sides sides(c.x, c.y);
  REQUIRE(sides.finished.graph.arcs.size() == 1);
  CHECK(sides.finished.graph.arcs[0].contact == Contact::tangential);
}

TEST_CASE("boundary graph: a side that is one point is one node", "[sweep]") {
  // (u v, v, 0) is the point (0, 0, 0) on v = 0; the plane meets it in that point, and along u = 1/2.
  ControlNet c{};
  c[1][1] = {1, 0, 0};
  c[0][1] = {0, 1, 0};
  const BezierPatch x = BezierPatch::from_power_basis(c);
  const BezierPatch y = plane({q(-1, 4), q(-1, 2), q(-1, 2)}, {0, 0, 1}, {q(1, 2), 1, 0});
  const Sides sides(x, y);
  CHECK(sides.undecided.empty());
  std::size_t collapsed = 0;
  for (const SideArc& arc : sides.lines.arcs) collapsed += arc.collapsed ? 1 : 0;
  CHECK(collapsed == 1);
  CHECK(sides.finished.graph.arcs.empty());  // u = 1/2 is no arc on a side
}

TEST_CASE("boundary graph: a star leaves the sides if one of its ports is inside", "[sweep]") {
  const ExactCase c = families::shared_side({q(-1, 2), q(3, 2), 0});
  const BoundaryLines lines = boundary_lines(c.x, c.y, model_scale(c.x, c.y), 1e-6, {});
  REQUIRE_FALSE(lines.points.empty());
  const CertifiedPoint& on_side = lines.points.front();
  StarNeighbourhood star{on_side, Parameter::u, on_side.box(), {}, {}};
  CHECK_FALSE(leaves_sides(star));
  star.ports.push_back({on_side, Parameter::v, 1});
  CHECK_FALSE(leaves_sides(star));
  const LinePoints across = line_points(graph_patch(kCircle), plane_patch(), {Parameter::u, q(1, 2)});
  REQUIRE(across.points.size() == 2);
  star.ports.push_back({across.points.front(), Parameter::u, 1});
  CHECK(leaves_sides(star));
}

}  // namespace exsect::boundary_graph_test
