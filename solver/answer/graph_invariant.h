// What is true of every complete intersection graph, however it was found. Internal to solver/;
// docs/method.md, section 8.1.
#pragma once

#include <exsect/solver/intersection_graph.h>
#include <exsect/solver/result.h>

#include <functional>
#include <optional>
#include <vector>

namespace exsect {

/// What is known of an intersection besides its graph.
struct GraphFacts {
  /// All turning points with respect to these parameters are nodes: every arc is monotone in them.
  std::vector<Parameter> turning = {};
  /// The number of arcs that end in the node, if that is known from its place alone.
  std::function<std::optional<int>(const Node&)> degree = {};
  /// Of every pair of points of one patch only one order is shown: the arcs of a pair may end in two nodes,
  /// one for each order.
  bool one_order = false;
};

/// The number of ends of arcs at every node.
std::vector<int> degrees(const IntersectionGraph& graph);

/// Violations of the invariant, each with a place and what is wrong there; none says that the graph is right.
/// Ids are positions and components are formed. reach[i] is that of GraphBuilder::add_node() for node i.
std::vector<Incomplete> violations_of(const IntersectionGraph& graph, std::vector<double> reach,
                                      const GraphFacts& facts);

/// As many components of every shape, boundary points, isolated points, overlaps, and turning points with
/// respect to each parameter, which are u, v of the one graph where they are r, s of the other one.
bool have_same_counts(const IntersectionGraph& graph, const IntersectionGraph& of_exchanged);

}  // namespace exsect
