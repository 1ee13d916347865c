#include "answer/graph_builder.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace exsect {

namespace {

int find_root(std::vector<int>& parent, int i) {
  while (parent[static_cast<std::size_t>(i)] != i) {
    i = parent[static_cast<std::size_t>(i)] =
        parent[static_cast<std::size_t>(parent[static_cast<std::size_t>(i)])];
  }
  return i;
}

/// Applies `change` to every node id in arcs, isolated points and overlaps.
template <class Change>
void for_each_node_id(IntersectionGraph& graph, const Change& change) {
  const auto change_ends = [&](std::vector<Arc>& arcs) {
    for (Arc& arc : arcs) {
      change(arc.from);
      change(arc.to);
    }
  };
  change_ends(graph.arcs);
  std::for_each(graph.isolated_points.begin(), graph.isolated_points.end(), change);
  for (Overlap& overlap : graph.overlaps) {
    std::for_each(overlap.chains.begin(), overlap.chains.end(), change_ends);
  }
}

/// Removes the nodes that no arc, no isolated point and no overlap names, and renumbers.
void drop_unused_nodes(IntersectionGraph& graph) {
  std::vector<int> renamed(graph.nodes.size(), -1);
  for_each_node_id(graph, [&](const int& id) { renamed[static_cast<std::size_t>(id)] = 0; });
  std::vector<Node> kept;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    if (renamed[i] == 0) {
      renamed[i] = static_cast<int>(kept.size());
      kept.push_back(std::move(graph.nodes[i]));
      kept.back().id = renamed[i];
    }
  }
  graph.nodes = std::move(kept);
  for_each_node_id(graph, [&](int& id) { id = renamed[static_cast<std::size_t>(id)]; });
}

}  // namespace

std::optional<Incomplete> too_coarse(const IntersectionGraph& graph, const Arc& arc, double tolerance) {
  if (arc.error_bound <= tolerance) {
    return std::nullopt;
  }
  return Incomplete{
      graph.nodes[static_cast<std::size_t>(arc.from)].box,
      "the tolerance is below what a polyline in doubles can be proved to keep on the arc from here"};
}

void finish_components(IntersectionGraph& graph) {
  std::vector<int> parent(graph.nodes.size());
  std::iota(parent.begin(), parent.end(), 0);
  std::vector<int> degree(graph.nodes.size(), 0);
  for (const Arc& arc : graph.arcs) {
    ++degree[static_cast<std::size_t>(arc.from)];
    ++degree[static_cast<std::size_t>(arc.to)];
    parent[static_cast<std::size_t>(find_root(parent, arc.from))] = find_root(parent, arc.to);
  }
  std::vector<int> component_of(graph.nodes.size(), -1);
  for (Arc& arc : graph.arcs) {
    int& id = component_of[static_cast<std::size_t>(find_root(parent, arc.from))];
    if (id < 0) {
      id = static_cast<int>(graph.components.size());
      graph.components.push_back({id, ComponentShape::closed, {}});
    }
    arc.component = id;
    Component& component = graph.components[static_cast<std::size_t>(id)];
    component.arcs.push_back(arc.id);
    const int most =
        std::max(degree[static_cast<std::size_t>(arc.from)], degree[static_cast<std::size_t>(arc.to)]);
    const int least =
        std::min(degree[static_cast<std::size_t>(arc.from)], degree[static_cast<std::size_t>(arc.to)]);
    if (most > 2) {
      component.shape = ComponentShape::branched;
    } else if (least == 1 && component.shape != ComponentShape::branched) {
      component.shape = ComponentShape::open;
    }
  }
  drop_unused_nodes(graph);
}

}  // namespace exsect
