#include "trace/contact_graph.h"

#include <cmath>

#include "support/bent_contact.h"
#include "trace/in_domain.h"
#include "trace/landmark_node.h"

namespace exsect::contact_graph_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the bent contact

const ModelFrame kUnmoved = {{0, 0, 0}, 0};

struct Drawn {
  BentContact contact;
  IntersectionGraph graph;

  Drawn(const std::vector<Parameter>& wanted, double tolerance) {
    const auto arc = contact.traced();
    auto turns = find_contact_turns(contact.system, arc, contact.pair, {});
    REQUIRE(std::holds_alternative<TurningPoints<DoubleBall>>(turns));
    GraphBuilder builder;
    for (const BallPoint<DoubleBall>& end : contact.ends) {
      ParameterBox box;
      for (std::size_t j = 0; j < 4; ++j) box[j] = in_domain(end[j].interval());
      builder.add_node(landmark_node(contact.system, kUnmoved, end, box, {}));
    }
    const AnalysedContact<DoubleBall> analysed{arc, std::get<TurningPoints<DoubleBall>>(turns)};
    append_contact(builder, contact.system, analysed, contact.ends, nodes_of_landmarks(2), kUnmoved, wanted,
                   tolerance);
    graph.nodes = builder.nodes();
    graph.arcs = builder.arcs();
  }
};

/// Every vertex, and every chord's middle, is near the contact.
void check_polyline(const Arc& arc) {
  REQUIRE(arc.polyline.size() >= 2);
  const auto distance = [](double x, double y) { return std::fabs(x - y) / std::sqrt(2.0); };
  for (std::size_t i = 0; i < arc.polyline.size(); ++i) {
    const PolylineVertex& here = arc.polyline[i];
    CHECK(distance(here.point[0], here.point[1]) <= arc.error_bound);
    const double u = here.parameters[0];
    CHECK(here.parameters[2] == Approx(u - 2 * (u - 0.5) * (u - 0.5)).margin(1e-12));
    if (i > 0) CHECK(std::fabs(here.parameters[0] - arc.polyline[i - 1].parameters[0]) < 0.5);
  }
}

}  // namespace

TEST_CASE("contact graph: one arc between the landmarks, or two that meet in the turning point", "[trace]") {
  for (const bool turning : {false, true}) {
    const Drawn drawn(turning ? std::vector{Parameter::r} : std::vector<Parameter>{}, 1e-6);
    REQUIRE(drawn.graph.nodes.size() == (turning ? 3 : 2));
    REQUIRE(drawn.graph.arcs.size() == (turning ? 2 : 1));
    for (const Arc& arc : drawn.graph.arcs) {
      CHECK(arc.contact == Contact::tangential);
      CHECK(arc.place == ArcPlace::interior);
      CHECK(arc.error_bound <= (turning ? 1e-5 : 1e-6));  // the box of a turning point counts
      check_polyline(arc);
    }
    CHECK(drawn.graph.arcs.front().from + drawn.graph.arcs.back().to == 1);
    if (!turning) continue;
    CHECK(drawn.graph.arcs[0].to == 2);
    CHECK(drawn.graph.arcs[1].from == 2);
    CHECK(drawn.graph.nodes[2].wrt == std::vector<Parameter>{Parameter::r});
    CHECK(drawn.graph.nodes[2].approx[0] == Approx(0.75).margin(1e-4));
  }
}

TEST_CASE("contact graph: a parameter that does not turn adds no node", "[trace]") {
  const Drawn drawn({Parameter::u, Parameter::v, Parameter::s}, 1e-3);
  CHECK(drawn.graph.nodes.size() == 2);
  CHECK(drawn.graph.arcs.size() == 1);
}

}  // namespace exsect::contact_graph_test
