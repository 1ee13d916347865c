#include "trace/trace_graph.h"

#include <cmath>

#include "support/known_curves.h"
#include "trace/landmark_node.h"

namespace exsect::trace_graph_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

const ModelFrame kFrame = {{0, 0, 0}, 0};

AnalysedTrace<DoubleBall> analysed(const HeightCoefficients& h, Trace<DoubleBall> trace) {
  auto turning = find_turning_points(system_of<DoubleBall>(h), trace, {2, 3, 0, 1});
  REQUIRE(std::holds_alternative<TurningPoints<DoubleBall>>(turning));
  return {std::move(trace), std::get<TurningPoints<DoubleBall>>(std::move(turning))};
}

/// The largest distance of sampled chords from the circle, and the length of the polyline.
struct Drawn {
  double off = 0;
  double length = 0;
};
Drawn against_circle(const std::vector<PolylineVertex>& line) {
  Drawn drawn;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const auto &a = line[i].point, &b = line[i + 1].point;
    drawn.length += std::hypot(b[0] - a[0], b[1] - a[1]);
    for (const double t : {0.0, 0.5, 1.0}) {
      const double x = a[0] + t * (b[0] - a[0]) - 0.5, y = a[1] + t * (b[1] - a[1]) - 0.5;
      drawn.off = std::max(drawn.off, std::fabs(std::hypot(x, y) - 1.0 / 3));
    }
  }
  return drawn;
}

}  // namespace

TEST_CASE("trace graph: arcs of a circle between the wanted turning points", "[trace]") {
  const AnalysedTrace<DoubleBall> curve = analysed(kCircle, circle_trace());
  const std::vector<std::pair<std::vector<Parameter>, std::size_t>> wanted = {
      {{}, 4},  // a closed curve without any gets all
      {{Parameter::u}, 2},
      {{Parameter::s}, 2},
      {{Parameter::u, Parameter::v}, 4},
      {{Parameter::u, Parameter::r}, 2}};
  for (const auto& [parameters, count] : wanted) {
    for (const double tolerance : {1e-2, 1e-5, 1e-8}) {
      GraphBuilder graph;
      append_trace(graph, curve, {}, {}, kFrame, parameters, tolerance);
      CHECK(graph.nodes().size() == count);
      CHECK(graph.arcs().size() == count);
      double length = 0;
      for (const Arc& arc : graph.arcs()) {
        CHECK(arc.error_bound <= tolerance);
        const Drawn drawn = against_circle(arc.polyline);
        CHECK(drawn.off <= arc.error_bound);
        length += drawn.length;
        for (const auto& [node, vertex] :
             {std::pair(arc.from, arc.polyline.front()), {arc.to, arc.polyline.back()}})
          CHECK(graph.node(node).approx == vertex.parameters);
      }
      CHECK(length == Approx(2 * std::acos(-1.0) / 3).epsilon(0.05));
    }
  }
}

TEST_CASE("trace graph: an arc from landmark to landmark, with an approach", "[trace]") {
  const auto system = system_of<DoubleBall>(kParabola);
  const Landmarks<DoubleBall> landmarks = {on_diagonal(0, q(13, 36)), on_diagonal(1, q(25, 36))};
  const AnalysedTrace<DoubleBall> curve =
      analysed(kParabola, require_trace(trace_arc(system, landmarks, 0, 1, {})));
  const auto drawn = [&](const std::vector<TraceEnd>& ends, const std::vector<Parameter>& parameters) {
    GraphBuilder graph;
    for (const auto& [u, v] : {std::pair(q(0), q(13, 36)), {q(1), q(25, 36)}})
      graph.add_node(landmark_node(system, kFrame, on_diagonal(u, v),
                                   ParameterBox{{{u, u}, {v, v}, {u, u}, {v, v}}},
                                   {{Parameter::u, u == 0 ? 0 : 1}}));
    append_trace(graph, curve, landmarks, ends, kFrame, parameters, 1e-6);
    return graph;
  };
  CHECK(nodes_of_landmarks(2).size() == 2);
  const GraphBuilder whole = drawn(nodes_of_landmarks(2), {});
  REQUIRE(whole.arcs().size() == 1);
  CHECK(whole.arcs()[0].from == 0);
  CHECK(whole.arcs()[0].to == 1);
  CHECK(drawn(nodes_of_landmarks(2), {Parameter::v}).arcs().size() == 2);

  // The end is a port of the star of node 0: the approach's vertices and its bound are in the arc.
  std::vector<TraceEnd> ends = nodes_of_landmarks(2);
  const PolylineVertex between = {{2, 2, 2, 2}, {2, 2, 0}};
  ends[1] = {0, Approach{{between}, 0.5}};
  const GraphBuilder port = drawn(ends, {});
  REQUIRE(port.arcs().size() == 1);
  CHECK(port.arcs()[0].to == 0);
  CHECK(port.arcs()[0].error_bound >= 0.5);
  CHECK(std::any_of(port.arcs()[0].polyline.begin(), port.arcs()[0].polyline.end(),
                    [&](const PolylineVertex& v) { return v.parameters == between.parameters; }));
}

}  // namespace exsect::trace_graph_test
