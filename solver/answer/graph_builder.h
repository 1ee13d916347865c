// The maker of intersection graphs: ids, components and the invariant in one place. Internal to solver/.
#pragma once

#include <exsect/solver/intersection_graph.h>
#include <exsect/solver/result.h>

#include <optional>
#include <vector>

#include "answer/graph_invariant.h"

namespace exsect {

/// A graph, and what is wrong with it.
struct FinishedGraph {
  IntersectionGraph graph;
  std::vector<Incomplete> violations;
};

/// Nodes and arcs while they are collected. Invariant: ids are positions; ids of arcs of overlaps count
/// through the chains of the overlap. Nodes that nothing names yet are allowed, and there are no components.
class GraphBuilder {
 public:
  GraphBuilder() = default;
  /// Takes a graph up again.
  explicit GraphBuilder(IntersectionGraph graph);

  const std::vector<Node>& nodes() const { return graph_.nodes; }
  const std::vector<Arc>& arcs() const { return graph_.arcs; }
  const std::vector<int>& isolated_points() const { return graph_.isolated_points; }
  const std::vector<Overlap>& overlaps() const { return graph_.overlaps; }
  const Node& node(int id) const { return graph_.nodes[static_cast<std::size_t>(id)]; }

  /// Returns the id. Every point of the node's box is within `reach` of Node::approx in each parameter that
  /// is not free; negative: to be found from the box.
  int add_node(Node node, double reach = -1);
  /// Returns the id. `from` and `to` may be nodes that are added later.
  int add_arc(Arc arc);
  /// Of one node without arcs.
  void add_isolated(int node) { graph_.isolated_points.push_back(node); }
  void add_overlap(std::vector<std::vector<Arc>> chains);

  /// Unless the node has it.
  void add_kind(int node, NodeKind kind);
  /// The node turns with respect to these parameters, ascending.
  void set_turning(int node, std::vector<Parameter> wrt);
  void set_contact(int arc, Contact contact);

  /// Takes away the arcs from id `first` on, in order.
  std::vector<Arc> take_arcs(int first);
  /// Takes away the overlaps, in order.
  std::vector<Overlap> take_overlaps();
  /// Puts one node in the place of others: the ends of arcs are moved to it, and the others are no isolated
  /// points any more; it is one if no arc ends in it.
  void contract(const std::vector<int>& nodes, Node replacement);

  /// Forms the components, drops the nodes that no arc, no isolated point and no overlap names, renumbers the
  /// others, and looks for violations of what `facts` require. What names a node that does not exist is
  /// dropped, which is a violation.
  FinishedGraph finish(const GraphFacts& facts) &&;

 private:
  std::vector<Incomplete> drop_dangling();
  void form_components();
  void order_components();
  void drop_unused_nodes();

  IntersectionGraph graph_;
  std::vector<double> reach_;  // of nodes
};

}  // namespace exsect
