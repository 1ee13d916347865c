#include "answer/graph_builder.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "answer/parameter_box.h"

namespace exsect {

namespace {

template <class T>
int next_id(const std::vector<T>& items) {
  return static_cast<int>(items.size());
}

int find_root(std::vector<int>& parent, int i) {
  while (parent[static_cast<std::size_t>(i)] != i) {
    i = parent[static_cast<std::size_t>(i)] =
        parent[static_cast<std::size_t>(parent[static_cast<std::size_t>(i)])];
  }
  return i;
}

/// Applies `change` to the node ids of every arc, isolated point and arc of an overlap.
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

int other_end(const Arc& arc, int node) { return arc.from == node ? arc.to : arc.from; }

/// Each arc begins where the one before it ends, in either direction.
bool is_walk(const IntersectionGraph& graph, const std::vector<int>& arcs) {
  const auto arc = [&](std::size_t i) -> const Arc& { return graph.arcs[static_cast<std::size_t>(arcs[i])]; };
  const auto ends_in = [](const Arc& a, int node) { return a.from == node || a.to == node; };
  if (arcs.size() < 2) return true;
  int at = ends_in(arc(1), arc(0).to) ? arc(0).to : arc(0).from;
  for (std::size_t i = 1; i < arcs.size(); ++i) {
    if (!ends_in(arc(i), at)) return false;
    at = other_end(arc(i), at);
  }
  return true;
}

/// The arcs of a path or a loop one after the other; `at_node` are the arcs that end in each node, which has
/// two at most. As they are if they are not one path or loop.
std::vector<int> walked(const IntersectionGraph& graph, const std::vector<int>& arcs,
                        const std::vector<std::vector<int>>& at_node) {
  const auto arc = [&](int id) -> const Arc& { return graph.arcs[static_cast<std::size_t>(id)]; };
  const auto is_end = [&](int node) { return at_node[static_cast<std::size_t>(node)].size() == 1; };
  int id = arcs.front(), at = arc(id).to;
  for (const int end : arcs) {
    if (!is_end(arc(end).from) && !is_end(arc(end).to)) continue;
    id = end;
    at = other_end(arc(id), is_end(arc(id).from) ? arc(id).from : arc(id).to);
    break;
  }
  std::vector<int> result = {id};
  while (result.size() < arcs.size()) {
    const std::vector<int>& here = at_node[static_cast<std::size_t>(at)];
    if (here.size() != 2) return arcs;
    id = here[0] == id ? here[1] : here[0];
    at = other_end(arc(id), at);
    result.push_back(id);
  }
  return result;
}

}  // namespace

GraphBuilder::GraphBuilder(IntersectionGraph graph) : graph_(std::move(graph)) {
  graph_.components.clear();
  reach_.assign(graph_.nodes.size(), -1);
  for (Arc& arc : graph_.arcs) arc.component = -1;
}

int GraphBuilder::add_node(Node node, double reach) {
  node.id = next_id(graph_.nodes);
  reach_.push_back(reach);
  graph_.nodes.push_back(std::move(node));
  return graph_.nodes.back().id;
}

int GraphBuilder::add_arc(Arc arc) {
  arc.id = next_id(graph_.arcs);
  arc.component = -1;
  graph_.arcs.push_back(std::move(arc));
  return graph_.arcs.back().id;
}

void GraphBuilder::add_overlap(std::vector<std::vector<Arc>> chains) {
  int id = 0;
  for (std::vector<Arc>& chain : chains) {
    for (Arc& arc : chain) {
      arc.id = id++;
      arc.component = -1;
    }
  }
  graph_.overlaps.push_back({next_id(graph_.overlaps), std::move(chains)});
}

void GraphBuilder::add_kind(int node, NodeKind kind) {
  std::vector<NodeKind>& kinds = graph_.nodes[static_cast<std::size_t>(node)].kinds;
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
    kinds.push_back(kind);
  }
}

void GraphBuilder::set_turning(int node, std::vector<Parameter> wrt) {
  graph_.nodes[static_cast<std::size_t>(node)].wrt = std::move(wrt);
}

void GraphBuilder::set_contact(int arc, Contact contact) {
  graph_.arcs[static_cast<std::size_t>(arc)].contact = contact;
}

std::vector<Arc> GraphBuilder::take_arcs(int first) {
  const auto from = graph_.arcs.begin() + first;
  std::vector<Arc> taken(std::make_move_iterator(from), std::make_move_iterator(graph_.arcs.end()));
  graph_.arcs.erase(from, graph_.arcs.end());
  return taken;
}

std::vector<Overlap> GraphBuilder::take_overlaps() { return std::exchange(graph_.overlaps, {}); }

void GraphBuilder::contract(const std::vector<int>& nodes, Node replacement) {
  const auto replaced = [&](int id) { return std::find(nodes.begin(), nodes.end(), id) != nodes.end(); };
  const int id = add_node(std::move(replacement));
  bool used = false;
  for (Arc& arc : graph_.arcs) {
    for (int* end : {&arc.from, &arc.to}) {
      if (replaced(*end)) {
        *end = id;
        used = true;
      }
    }
  }
  std::erase_if(graph_.isolated_points, replaced);
  if (!used) {
    add_isolated(id);
  }
}

FinishedGraph GraphBuilder::finish(const GraphFacts& facts) && {
  std::vector<Incomplete> violations = drop_dangling();
  drop_unused_nodes();
  form_components();
  order_components();
  std::vector<Incomplete> found = violations_of(graph_, reach_, facts);
  violations.insert(violations.end(), std::make_move_iterator(found.begin()),
                    std::make_move_iterator(found.end()));
  return {std::move(graph_), std::move(violations)};
}

/// What names a node that does not exist.
std::vector<Incomplete> GraphBuilder::drop_dangling() {
  const int count = next_id(graph_.nodes);
  const auto exists = [&](int id) { return id >= 0 && id < count; };
  std::size_t dropped = 0;
  const auto drop_arcs = [&](std::vector<Arc>& arcs) {
    dropped += std::erase_if(arcs, [&](const Arc& arc) { return !exists(arc.from) || !exists(arc.to); });
  };
  drop_arcs(graph_.arcs);
  for (Overlap& overlap : graph_.overlaps) {
    std::for_each(overlap.chains.begin(), overlap.chains.end(), drop_arcs);
  }
  dropped += std::erase_if(graph_.isolated_points, [&](int id) { return !exists(id); });
  if (dropped == 0) {
    return {};
  }
  for (std::size_t i = 0; i < graph_.arcs.size(); ++i) {
    graph_.arcs[i].id = static_cast<int>(i);
  }
  return {{whole_domain(), "an arc or an isolated point without a node"}};
}

void GraphBuilder::form_components() {
  std::vector<int> parent(graph_.nodes.size());
  std::iota(parent.begin(), parent.end(), 0);
  const std::vector<int> degree = degrees(graph_);
  for (const Arc& arc : graph_.arcs) {
    parent[static_cast<std::size_t>(find_root(parent, arc.from))] = find_root(parent, arc.to);
  }
  std::vector<int> component_of(graph_.nodes.size(), -1);
  for (Arc& arc : graph_.arcs) {
    int& id = component_of[static_cast<std::size_t>(find_root(parent, arc.from))];
    if (id < 0) {
      id = next_id(graph_.components);
      graph_.components.push_back({id, ComponentShape::closed, {}});
    }
    arc.component = id;
    Component& component = graph_.components[static_cast<std::size_t>(id)];
    component.arcs.push_back(arc.id);
    const auto [least, most] =
        std::minmax({degree[static_cast<std::size_t>(arc.from)], degree[static_cast<std::size_t>(arc.to)]});
    if (most > 2) {
      component.shape = ComponentShape::branched;
    } else if (least == 1 && component.shape != ComponentShape::branched) {
      component.shape = ComponentShape::open;
    }
  }
}

/// Of open and closed components in the order along the curve, as they were added where that is such an
/// order.
void GraphBuilder::order_components() {
  const auto is_ordered = [&](const Component& component) {
    return component.shape == ComponentShape::branched || is_walk(graph_, component.arcs);
  };
  if (std::ranges::all_of(graph_.components, is_ordered)) return;
  std::vector<std::vector<int>> at_node(graph_.nodes.size());
  for (const Arc& arc : graph_.arcs) {
    at_node[static_cast<std::size_t>(arc.from)].push_back(arc.id);
    at_node[static_cast<std::size_t>(arc.to)].push_back(arc.id);
  }
  for (Component& component : graph_.components)
    if (!is_ordered(component)) component.arcs = walked(graph_, component.arcs, at_node);
}

void GraphBuilder::drop_unused_nodes() {
  std::vector<int> renamed(graph_.nodes.size(), -1);
  for_each_node_id(graph_, [&](const int& id) { renamed[static_cast<std::size_t>(id)] = 0; });
  int count = 0;
  for (std::size_t i = 0; i < renamed.size(); ++i) {
    if (renamed[i] < 0) {
      continue;
    }
    const auto to = static_cast<std::size_t>(count);
    if (to != i) {
      graph_.nodes[to] = std::move(graph_.nodes[i]);
      reach_[to] = reach_[i];
    }
    graph_.nodes[to].id = renamed[i] = count++;
  }
  graph_.nodes.resize(static_cast<std::size_t>(count));
  reach_.resize(static_cast<std::size_t>(count));
  for_each_node_id(graph_, [&](int& id) { id = renamed[static_cast<std::size_t>(id)]; });
}

}  // namespace exsect
