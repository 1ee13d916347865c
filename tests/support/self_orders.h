// Graphs of self-intersections with all pairs in both of their orders, to be compared.
#pragma once

#include <algorithm>
#include <map>
#include <utility>

#include "support/graph_isomorphism.h"

namespace exsect::testing {

template <class T>
std::array<T, 4> in_other_order(const std::array<T, 4>& pair) {
  return {pair[2], pair[3], pair[0], pair[1]};
}

inline Node in_other_order(Node node) {
  const auto other = [](Parameter p) { return all_parameters[(index(p) + 2) % 4]; };
  node.approx = in_other_order(node.approx);
  node.box = in_other_order(node.box);
  for (Parameter& p : node.wrt) p = other(p);
  for (Parameter& p : node.free) p = other(p);
  for (Side& side : node.on) side.parameter = other(side.parameter);
  return node;
}

inline bool is_one_node(const Node& a, const Node& b) {
  for (std::size_t j = 0; j < 4; ++j)
    if (a.box[j].upper < b.box[j].lower || b.box[j].upper < a.box[j].lower) return false;
  return a.kinds == b.kinds;
}

/// The arcs, with ids from 0, in components that hang together, with the shapes they have.
inline std::vector<Component> components_of(std::vector<Arc>& arcs, const std::vector<Component>& given) {
  std::vector<int> sets(arcs.size());
  for (std::size_t i = 0; i < sets.size(); ++i) sets[i] = static_cast<int>(i);
  std::map<int, int> first;  // arc of a node
  for (const Arc& arc : arcs)
    for (const int end : {arc.from, arc.to}) {
      const int known = sets[static_cast<std::size_t>(first.try_emplace(end, arc.id).first->second)];
      std::ranges::replace(sets, sets[static_cast<std::size_t>(arc.id)], known);
    }
  std::vector<Component> result;
  std::map<int, int> names;
  for (Arc& arc : arcs) {
    const auto shape = given[static_cast<std::size_t>(arc.component)].shape;
    arc.component = names.try_emplace(sets[static_cast<std::size_t>(arc.id)], static_cast<int>(names.size()))
                        .first->second;
    if (arc.component == static_cast<int>(result.size())) result.push_back({arc.component, shape, {}});
    result[static_cast<std::size_t>(arc.component)].arcs.push_back(arc.id);
  }
  return result;
}

/// Every node and arc once as it is and once in the other order; a node that is the same in both, where a
/// curve ends in a pair of equal points, once. Overlaps remain as they are.
inline IntersectionGraph in_both_orders(IntersectionGraph graph) {
  std::vector<int> mates;
  const std::size_t nodes = graph.nodes.size();
  for (std::size_t i = 0; i < nodes; ++i) {
    Node mate = in_other_order(graph.nodes[i]);
    const auto known = std::find_if(graph.nodes.begin(), graph.nodes.begin() + static_cast<long>(nodes),
                                    [&](const Node& node) { return is_one_node(node, mate); });
    mate.id = static_cast<int>(graph.nodes.size());
    mates.push_back(known == graph.nodes.begin() + static_cast<long>(nodes) ? mate.id : known->id);
    if (mates.back() == mate.id) graph.nodes.push_back(std::move(mate));
  }
  const std::size_t arcs = graph.arcs.size();
  for (std::size_t i = 0; i < arcs; ++i) {
    Arc arc = graph.arcs[i];
    arc.id = static_cast<int>(graph.arcs.size());
    arc.from = mates[static_cast<std::size_t>(arc.from)];
    arc.to = mates[static_cast<std::size_t>(arc.to)];
    for (PolylineVertex& v : arc.polyline) v.parameters = in_other_order(v.parameters);
    graph.arcs.push_back(std::move(arc));
  }
  graph.components = components_of(graph.arcs, graph.components);
  for (const int id : std::vector<int>(graph.isolated_points))
    if (const int mate = mates[static_cast<std::size_t>(id)]; mate != id)
      graph.isolated_points.push_back(mate);
  return graph;
}

}  // namespace exsect::testing
