#include "filter/graph.h"

#include <cmath>

#include "filter/loops.h"
#include "known_curve.h"

namespace exsect::graph_test {
namespace {

using testing::KnownCurve;

constexpr std::array<std::size_t, 4> kTogether = {0, 1, 0, 1};

filter::AnalysedTrace analysed(const KnownCurve& curve, filter::Trace trace) {
  filter::KnownTurning<filter::Biquadratic> known;
  known.coincident = kTogether;
  filter::AnalysedTrace result{std::move(trace), {}};
  REQUIRE(filter::find_turns<filter::Biquadratic>(curve.pair, result.trace, known, result.turns) ==
          filter::TurnSearch::done);
  return result;
}

std::optional<GraphBuilder> drawn(const KnownCurve& curve, const filter::AnalysedTrace& trace,
                                  const std::vector<Parameter>& wanted, const filter::Drawing& drawing) {
  return filter::make_graph<filter::Biquadratic>(curve.pair, curve.points, {}, {trace}, wanted, kTogether,
                                                 drawing);
}

}  // namespace

TEST_CASE("filter graph: an arc between two sides, its chords within the tolerance of the hyperbola",
          "[filter]") {
  const KnownCurve curve(testing::kHyperbola);
  const auto trace = analysed(curve, curve.arc());
  std::size_t vertices = 0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    const auto graph = drawn(curve, trace, {}, {tolerance, tolerance, tolerance});
    REQUIRE(graph);
    REQUIRE(graph->nodes().size() == 2);
    REQUIRE(graph->arcs().size() == 1);
    const Arc& arc = graph->arcs()[0];
    CHECK(arc.error_bound <= tolerance);
    CHECK(arc.polyline.size() > vertices);
    vertices = arc.polyline.size();
    for (std::size_t i = 0; i + 1 < vertices; ++i) {
      // At a chord's middle (X,Y) the hyperbola is nearer than |XY - 1/4|.
      const auto &a = arc.polyline[i].point, &b = arc.polyline[i + 1].point;
      const double x = 0.5 * (a[0] + b[0]), y = 0.5 * (a[1] + b[1]);
      CHECK(std::fabs(x - 1 / (4 * y)) <= 8 * arc.error_bound);
    }
  }
  // What cannot be proved to be so near is refused.
  CHECK_FALSE(drawn(curve, trace, {}, {1e-2, 1e-2, 1e-9}));
}

TEST_CASE("filter graph: a closed curve has its turning points as nodes, all if none is wanted", "[filter]") {
  KnownCurve curve(testing::kCircle);
  std::vector<filter::Trace> traces;
  filter::Vec4 stuck;
  REQUIRE(filter::add_loops<filter::Biquadratic>(curve.pair, {}, {}, curve.trees, curve.points, traces,
                                                 curve.boxes, stuck));
  REQUIRE(traces.size() == 1);
  const auto trace = analysed(curve, traces[0]);
  CHECK(trace.turns.size() == 4);
  for (const auto& [wanted, count] :
       {std::pair(std::vector<Parameter>{}, 4U), std::pair(std::vector{Parameter::u}, 2U),
        std::pair(std::vector{Parameter::v, Parameter::s}, 2U),
        std::pair(std::vector{Parameter::u, Parameter::s}, 4U)}) {
    const auto graph = drawn(curve, trace, wanted, {1e-4, 1e-4, 1e-4});
    REQUIRE(graph);
    CHECK(graph->nodes().size() == count);
    CHECK(graph->arcs().size() == count);
    for (const Node& node : graph->nodes()) {
      const double a = node.approx[0] - 0.5, b = node.approx[1] - 0.5;
      CHECK(std::min(std::fabs(a), std::fabs(b)) < 1e-6);
      CHECK(std::max(std::fabs(a), std::fabs(b)) == Approx(1.0 / 3).margin(1e-6));
    }
  }
}

}  // namespace exsect::graph_test
