#include "filter/contact_graph.h"

#include "filter/contact_finder.h"
#include "support/catch.h"
#include "support/families.h"
#include "support/known_curves.h"

namespace exsect::contact_graph_test {
namespace {

using filter::Biquadratic;

std::optional<GraphBuilder> graph_of(const BezierPatch& x, const BezierPatch& y, double accepted = 1e-6) {
  const filter::Pair pair = filter::make_pair(x, y).value();
  const auto contacts = filter::find_contacts<Biquadratic>(x, y, pair);
  REQUIRE(contacts);
  GraphBuilder graph;
  if (!filter::append_contacts<Biquadratic>(x, y, pair, *contacts, 1e-6, accepted, graph))
    return std::nullopt;
  return graph;
}

}  // namespace

TEST_CASE("contact graph in doubles: a shared side is an arc between two corners", "[filter]") {
  const ExactCase c = families::shared_side({0, 1, 0});
  const auto graph = graph_of(c.x, c.y);
  REQUIRE(graph);
  REQUIRE(graph->nodes().size() == 2);
  REQUIRE(graph->arcs().size() == 1);
  const Arc& arc = graph->arcs()[0];
  CHECK(arc.place == ArcPlace::patch_boundary);
  CHECK(arc.contact == Contact::transversal);
  CHECK(arc.error_bound <= 1e-6);
  // Both patches have the vertices on u = 0 and r = 0.
  for (const PolylineVertex& vertex : arc.polyline) {
    CHECK(vertex.parameters[0] == 0);
    CHECK(vertex.parameters[2] == 0);
    const Point on_x = c.x(from_double(vertex.parameters[0]), from_double(vertex.parameters[1]));
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(std::fabs(vertex.point[i] - to_double(on_x[i])) <= 2 * arc.error_bound);
  }
}

TEST_CASE("contact graph in doubles: a common corner is an isolated node", "[filter]") {
  const auto graph = graph_of(testing::plane_patch(), testing::plane({1, 1, 0}, {1, 0, 1}, {0, 1, 1}));
  REQUIRE(graph);
  CHECK(graph->arcs().empty());
  REQUIRE(graph->nodes().size() == 1);
  CHECK(graph->isolated_points() == std::vector<int>{0});
  CHECK(graph->node(0).approx == std::array<double, 4>{1, 1, 0, 0});
}

TEST_CASE("contact graph in doubles: a bound that is not kept is refused", "[filter]") {
  const ExactCase c = families::smooth_neighbour(1);
  CHECK_FALSE(graph_of(c.x, c.y, 1e-30));
}

}  // namespace exsect::contact_graph_test
