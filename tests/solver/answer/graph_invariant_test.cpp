#include "answer/graph_invariant.h"

#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "answer/finished_result.h"
#include "answer/parameter_box.h"
#include "support/catch.h"
#include "support/random_pairs.h"
#include "trace/regular_degree.h"

namespace exsect::graph_invariant_test {
using random_pairs::Generator;
using random_pairs::Pair;

namespace {

const std::vector<Parameter> kAll = {all_parameters.begin(), all_parameters.end()};

/// A closed curve and an open one.
Pair loop_and_arc() {
  const auto patches = read_patches(EXSECT_EXAMPLES "/chapter9-first.json").patches;
  return {patches[0].patch, patches[1].patch};
}

struct Intersected {
  Pair pair;
  IntersectionGraph graph;

  explicit Intersected(Pair of) : pair(std::move(of)) {
    IntersectOptions options;
    options.turning = kAll;
    const IntersectResult result = intersect(pair.x, pair.y, options);
    REQUIRE(result.status == Status::complete);
    graph = result.graph;
  }

  GraphFacts facts() const { return {kAll, RegularDegree(pair.x, pair.y)}; }
  IntersectResult made(IntersectionGraph forged) const {
    return finished(GraphBuilder(std::move(forged)), facts(), {});
  }
};

/// Some arc of a component of this shape.
Arc& arc_of(IntersectionGraph& graph, ComponentShape shape) {
  const auto at = std::find_if(graph.components.begin(), graph.components.end(),
                               [&](const Component& c) { return c.shape == shape; });
  REQUIRE(at != graph.components.end());
  return graph.arcs[static_cast<std::size_t>(at->arcs.front())];
}

Node& node_with(IntersectionGraph& graph, NodeKind kind) {
  const auto at = std::find_if(graph.nodes.begin(), graph.nodes.end(), [&](const Node& node) {
    return std::count(node.kinds.begin(), node.kinds.end(), kind) > 0;
  });
  REQUIRE(at != graph.nodes.end());
  return *at;
}

Arc reversed(Arc arc) {
  std::swap(arc.from, arc.to);
  std::reverse(arc.polyline.begin(), arc.polyline.end());
  return arc;
}

struct Forgery {
  std::string reason;  // a part of it
  std::function<void(IntersectionGraph&)> forge;
};

using enum ComponentShape;

const std::vector<Forgery> kForgeries = {
    {"2 arcs end in a point where the curve crosses a side",
     [](IntersectionGraph& g) { g.arcs.push_back(reversed(arc_of(g, open))); }},
    {"1 arcs end in a", [](IntersectionGraph& g) { g.arcs.erase(g.arcs.begin() + arc_of(g, closed).id); }},
    {"0 arcs end in a point where the curve crosses a side",
     [](IntersectionGraph& g) {
       g.isolated_points = {node_with(g, NodeKind::boundary).id};
       std::erase_if(g.arcs, [&](const Arc& arc) {
         return arc.from == g.isolated_points[0] || arc.to == g.isolated_points[0];
       });
     }},
    {"an arc ends in an isolated point",
     [](IntersectionGraph& g) { g.isolated_points = {arc_of(g, closed).to}; }},
    {"a polyline that ends off its node",
     [](IntersectionGraph& g) { arc_of(g, open).polyline.back().parameters[2] += 1e-6; }},
    {"a polyline that ends off its node",
     [](IntersectionGraph& g) {
       arc_of(g, open).polyline.front().parameters[1] = std::numeric_limits<double>::quiet_NaN();
     }},
    {"an arc without a polyline or a bound",
     [](IntersectionGraph& g) { arc_of(g, open).error_bound = std::numeric_limits<double>::quiet_NaN(); }},
    {"an arc without a polyline or a bound",
     [](IntersectionGraph& g) { arc_of(g, closed).polyline.resize(1); }},
    {"a boundary point off its side",
     [](IntersectionGraph& g) {
       Node& node = node_with(g, NodeKind::boundary);
       node.on[0].value = 1 - node.on[0].value;
     }},
    {"a boundary point on no side",
     [](IntersectionGraph& g) { node_with(g, NodeKind::boundary).on.clear(); }},
    {"a boundary point on no side",
     [](IntersectionGraph& g) { std::erase(node_with(g, NodeKind::boundary).kinds, NodeKind::boundary); }},
    {"a turning point with respect to no parameter",
     [](IntersectionGraph& g) { node_with(g, NodeKind::turning).wrt.clear(); }},
    {"turns at a point that is no turning point, or goes on at one",
     [](IntersectionGraph& g) {
       Node& node = node_with(g, NodeKind::turning);
       node.wrt = {all_parameters[(index(node.wrt[0]) + 1) % 4]};
     }},
    {"two nodes for one point",
     [](IntersectionGraph& g) {
       const auto nodes = static_cast<int>(g.nodes.size());
       std::vector<Arc> arcs = g.arcs;
       g.nodes.insert(g.nodes.end(), g.nodes.begin(), g.nodes.begin() + nodes);
       for (int i = 0; i < nodes; ++i) g.nodes[static_cast<std::size_t>(nodes + i)].id = nodes + i;
       for (Arc& arc : arcs) {
         arc.from += nodes;
         arc.to += nodes;
         g.arcs.push_back(arc);
       }
     }},
    {"arcs end in a regular point",
     [](IntersectionGraph& g) {
       Arc& arc = arc_of(g, closed);
       arc.to = arc_of(g, open).to;
       arc.polyline.back() = arc_of(g, open).polyline.back();
     }},
    {"arcs end in",
     [](IntersectionGraph& g) { node_with(g, NodeKind::turning).kinds.push_back(NodeKind::touch); }},
    {"arcs end in",
     [](IntersectionGraph& g) { node_with(g, NodeKind::turning).kinds = {NodeKind::crossing}; }},
    {"without a node", [](IntersectionGraph& g) { arc_of(g, open).to = 1000; }},
};

/// Ids in order, as makers hand them over.
void renumber(IntersectionGraph& graph) {
  for (std::size_t i = 0; i < graph.arcs.size(); ++i) graph.arcs[i].id = static_cast<int>(i);
}

}  // namespace

TEST_CASE("graph invariant: a true graph has no violations, every forged one is incomplete there") {
  const Intersected true_one(loop_and_arc());
  CHECK(true_one.made(true_one.graph).status == Status::complete);
  for (const Forgery& forgery : kForgeries) {
    INFO(forgery.reason);
    IntersectionGraph graph = true_one.graph;
    forgery.forge(graph);
    renumber(graph);
    const IntersectResult result = true_one.made(std::move(graph));
    CHECK(result.status == Status::incomplete);
    for (const Incomplete& found : result.incomplete) UNSCOPED_INFO(found.why);
    CHECK(std::any_of(result.incomplete.begin(), result.incomplete.end(), [&](const Incomplete& found) {
      return found.why.find(forgery.reason) != std::string::npos;
    }));
  }
}

TEST_CASE(
    "graph invariant: no arc of a generic intersection can be left out, doubled or joined to another one") {
  const std::uint64_t first = GENERATE(100U, 200U);
  for (std::uint64_t seed = first; seed < first + 15; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Intersected made(seed % 2 == 0 ? random_pairs::scattered(generator)
                                         : random_pairs::small_rationals(generator));
    CHECK(made.made(made.graph).status == Status::complete);
    for (std::size_t i = 0; i < made.graph.arcs.size(); ++i) {
      IntersectionGraph without = made.graph;
      without.arcs.erase(without.arcs.begin() + static_cast<std::ptrdiff_t>(i));
      renumber(without);
      const auto of = static_cast<std::size_t>(made.graph.arcs[i].component);
      const bool is_part = made.graph.components[of].arcs.size() > 1;
      CHECK((made.made(std::move(without)).status == Status::incomplete) == is_part);
      for (const bool backwards : {false, true}) {
        IntersectionGraph twice = made.graph;
        twice.arcs.push_back(backwards ? reversed(twice.arcs[i]) : twice.arcs[i]);
        renumber(twice);
        CHECK(made.made(std::move(twice)).status == Status::incomplete);
      }
    }
  }
}

TEST_CASE("graph invariant: an arc between two sides that is traced twice is no closed curve") {
  // The ends of an arc of length 1e-20 in the corner u = v = 0, as two arcs that close.
  GraphBuilder graph;
  const double tiny = 1e-20;
  for (const std::size_t side : {0U, 1U}) {
    Node node{};
    node.kinds = {NodeKind::boundary};
    node.on = {{static_cast<Parameter>(side), 0}};
    node.approx = {tiny, tiny, 0.25, 0.5};
    node.approx[side] = 0;
    for (std::size_t i = 0; i < 4; ++i)
      node.box[i] = {from_double(node.approx[i]), from_double(node.approx[i])};
    graph.add_node(node);
  }
  for (const int from : {0, 1}) {
    Arc arc{};
    arc.from = from;
    arc.to = 1 - from;
    arc.polyline = {{graph.node(from).approx, {}}, {graph.node(1 - from).approx, {}}};
    graph.add_arc(arc);
  }
  const auto reasons = [&](const GraphFacts& facts) {
    std::string all;
    for (const Incomplete& found : finished(graph, facts, {}).incomplete) all += found.why + "; ";
    return all;
  };
  CHECK(reasons({kAll}).find("a closed curve with 1 turning points with respect to u") != std::string::npos);
  CHECK(reasons({{Parameter::s}}).empty());  // s may be constant
  const auto one = [](const Node&) { return std::optional(1); };
  CHECK(reasons({{}, one}).find("2 arcs end in a point where the curve crosses a side") != std::string::npos);
}

TEST_CASE("graph invariant: arcs between two crossings are different, and even in number") {
  GraphBuilder graph;
  for (const double t : {0.25, 0.75}) {
    Node node{};
    node.kinds = {NodeKind::crossing};
    node.approx = {t, t, t, t};
    for (RationalInterval& i : node.box) i = {from_double(t), from_double(t)};
    graph.add_node(node);
  }
  Arc arc{};
  arc.to = 1;
  const auto add = [&](double middle) {
    arc.polyline = {{graph.node(0).approx, {}}, {{middle, 0.5, 0.5, 0.5}, {}}, {graph.node(1).approx, {}}};
    graph.add_arc(arc);
  };
  for (const double middle : {0.4, 0.5, 0.6}) add(middle);
  REQUIRE(!finished(graph, {}, {}).incomplete.empty());
  CHECK(finished(graph, {}, {}).incomplete[0].why == "3 arcs end in an inner crossing");
  CHECK(finished(graph, {{}, {}, true}, {}).status == Status::complete);
  GraphBuilder twice = graph;
  add(0.7);
  CHECK(finished(graph, {}, {}).status == Status::complete);
  twice.add_arc(reversed(twice.arcs()[1]));
  REQUIRE(finished(twice, {}, {}).incomplete.size() == 1);
  CHECK(finished(twice, {}, {}).incomplete[0].why == "an arc that is shown twice");
}

TEST_CASE("graph invariant: arcs on a side are even in number inside it") {
  GraphBuilder graph;
  for (const double v : {0.0, 0.5, 1.0}) {
    Node node{};
    node.kinds = {NodeKind::boundary};
    node.on = {{Parameter::u, 0}};
    if (v != 0.5) node.on.push_back({Parameter::v, static_cast<int>(v)});
    node.approx = {0, v, 0.5, 0.25 + 0.5 * v};
    for (std::size_t i = 0; i < 4; ++i)
      node.box[i] = {from_double(node.approx[i]), from_double(node.approx[i])};
    graph.add_node(node);
  }
  const auto add = [&](int from, int to) {
    Arc arc{};
    arc.from = from;
    arc.to = to;
    arc.place = ArcPlace::patch_boundary;
    arc.polyline = {{graph.node(from).approx, {}}, {graph.node(to).approx, {}}};
    graph.add_arc(arc);
  };
  add(0, 1);
  REQUIRE(finished(graph, {}, {}).incomplete.size() == 1);
  CHECK(finished(graph, {}, {}).incomplete[0].why == "1 arcs on a side end in a point inside that side");
  CHECK(finished(graph, {{}, {}, true}, {}).status == Status::complete);
  add(1, 2);
  CHECK(finished(graph, {}, {}).status == Status::complete);
}

TEST_CASE("graph invariant: a closed curve without turning points") {
  GraphBuilder graph;
  Node node{};
  node.approx = {0.5, 0.5, 0.5, 0.5};
  for (RationalInterval& i : node.box) i = {Rational(1, 2), Rational(1, 2)};
  graph.add_node(node);
  Arc arc{};
  arc.polyline = {{node.approx, {}}, {{0.5, 0.75, 0.5, 0.25}, {}}, {node.approx, {}}};
  graph.add_arc(arc);
  const auto result = finished(graph, {}, {});
  REQUIRE(result.incomplete.size() == 1);
  CHECK(result.incomplete[0].why == "a closed curve without turning points");
  CHECK(lies_in(result.incomplete[0].where, node.box));
}

TEST_CASE("graph invariant: counts of exchanged patches") {
  int compared = 0;
  for (std::uint64_t seed = 300; seed < 310; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Pair pair = random_pairs::scattered(generator);
    const Intersected there(pair);
    const Intersected back(Pair{pair.y, pair.x});
    CHECK(have_same_counts(there.graph, back.graph));
    IntersectionGraph other = back.graph;
    if (other.nodes.empty()) continue;
    ++compared;
    other.isolated_points.push_back(0);
    CHECK(!have_same_counts(there.graph, other));
    other = back.graph;
    other.components[0].shape = branched;
    CHECK(!have_same_counts(there.graph, other));
    other = back.graph;
    for (Node& node : other.nodes)
      for (Parameter& p : node.wrt) p = all_parameters[index(p) ^ 2];
    CHECK(have_same_counts(there.graph, other) ==
          (there.graph.turning_points(Parameter::u) == there.graph.turning_points(Parameter::r) &&
           there.graph.turning_points(Parameter::v) == there.graph.turning_points(Parameter::s)));
  }
  CHECK(compared >= 5);
}

}  // namespace exsect::graph_invariant_test
