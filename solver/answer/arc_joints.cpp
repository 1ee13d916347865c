#include "answer/arc_joints.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace exsect {
namespace {

/// Arcs that follow each other through unwanted nodes, in one direction.
template <class IsUnwanted>
std::vector<Arc> take_run(std::vector<Arc>& arcs, const IsUnwanted& is_unwanted) {
  std::vector<Arc> run = {std::move(arcs.back())};
  arcs.pop_back();
  for (const bool forward : {true, false}) {
    const auto end = [&] { return forward ? run.back().to : run.front().from; };
    while (is_unwanted(end()) && run.front().from != run.back().to) {
      const auto next =
          std::ranges::find_if(arcs, [&](const Arc& arc) { return arc.from == end() || arc.to == end(); });
      if (next == arcs.end()) break;
      if ((forward ? next->from : next->to) != end()) {
        std::swap(next->from, next->to);
        std::ranges::reverse(next->polyline);
        if (next->beside) std::swap(next->beside->left, next->beside->right);
      }
      run.insert(forward ? run.end() : run.begin(), std::move(*next));
      arcs.erase(next);
    }
  }
  return run;
}

void extend(Arc& arc, const Arc& by) {
  arc.polyline.insert(arc.polyline.end(), by.polyline.begin() + 1, by.polyline.end());
  arc.to = by.to;
  arc.error_bound = larger_bound(arc.error_bound, by.error_bound);
}

bool has_side(const std::vector<Side>& sides, const Side& side) {
  return std::ranges::count(sides, side) > 0;
}

/// The parameter along a side in which the node lies strictly between the ends of the arc, which is on that
/// side.
std::optional<std::size_t> along_arc(const std::vector<Node>& nodes, const Arc& arc, const Node& node) {
  if (arc.contact != Contact::tangential) return std::nullopt;
  const Node& from = nodes[static_cast<std::size_t>(arc.from)];
  const Node& to = nodes[static_cast<std::size_t>(arc.to)];
  for (const Side& side : node.on) {
    if (!has_side(from.on, side) || !has_side(to.on, side)) continue;
    const std::size_t j = index(side.parameter);
    const std::size_t along = j < 2 ? 1 - j : 5 - j;
    const RationalInterval& at = node.box[along];
    for (const auto& [a, b] :
         {std::pair(from.box[along], to.box[along]), std::pair(to.box[along], from.box[along])})
      if (a.upper < at.lower && at.upper < b.lower) return along;
  }
  return std::nullopt;
}

/// Parts of chords keep within the bound of the chords.
std::array<Arc, 2> divided(const Arc& arc, const Node& node, std::size_t along, double error) {
  std::array<Arc, 2> parts = {arc, arc};
  const bool ascending = arc.polyline.front().parameters[along] < arc.polyline.back().parameters[along];
  const auto behind = std::ranges::find_if(arc.polyline, [&](const PolylineVertex& vertex) {
    return (vertex.parameters[along] > node.approx[along]) == ascending;
  });
  const PolylineVertex middle = {node.approx, node.point};
  parts[0].polyline.assign(arc.polyline.begin(), behind);
  parts[0].polyline.push_back(middle);
  parts[1].polyline.assign(1, middle);
  parts[1].polyline.insert(parts[1].polyline.end(), behind, arc.polyline.end());
  parts[0].to = parts[1].from = node.id;
  for (Arc& part : parts) part.error_bound += error;
  return parts;
}

bool divide(const std::vector<Node>& nodes, std::vector<Arc>& arcs, const Node& node, double error) {
  bool found = false;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const auto along = along_arc(nodes, arcs[i], node);
    if (!along) continue;
    const std::array<Arc, 2> parts = divided(arcs[i], node, *along, error);
    arcs[i] = parts[0];
    arcs.insert(arcs.begin() + static_cast<std::ptrdiff_t>(i) + 1, parts[1]);
    found = true;
    ++i;
  }
  return found;
}

}  // namespace

bool divide_at(GraphBuilder& graph, int node, double error) {
  const Node& at = graph.node(node);
  std::vector<Arc> arcs = graph.take_arcs(0);
  bool found = divide(graph.nodes(), arcs, at, error);
  for (Arc& arc : arcs) graph.add_arc(std::move(arc));
  for (Overlap& overlap : graph.take_overlaps()) {
    for (std::vector<Arc>& chain : overlap.chains) found = divide(graph.nodes(), chain, at, error) || found;
    graph.add_overlap(std::move(overlap.chains));
  }
  return found;
}

std::vector<Arc> joined_chain(std::vector<Arc> chain, const std::function<bool(int)>& is_wanted) {
  std::ranges::rotate(chain,
                      std::ranges::find_if(chain, [&](const Arc& arc) { return is_wanted(arc.from); }));
  std::vector<Arc> joined;
  for (Arc& arc : chain)
    if (joined.empty() || is_wanted(arc.from))
      joined.push_back(std::move(arc));
    else
      extend(joined.back(), arc);
  return joined;
}

void join_at_nodes_of_no_kind(GraphBuilder& graph, int first_arc) {
  std::vector<Arc> arcs = graph.take_arcs(first_arc);
  while (!arcs.empty()) {
    std::vector<Arc> run = take_run(arcs, [&](int id) { return graph.node(id).kinds.empty(); });
    for (std::size_t i = 1; i < run.size(); ++i) extend(run.front(), run[i]);
    graph.add_arc(std::move(run.front()));
  }
}

void join_at_other_turning_points(GraphBuilder& graph, int first_node, int first_arc,
                                  const std::vector<Parameter>& wanted) {
  std::map<int, std::vector<Parameter>> kept;
  for (auto i = static_cast<std::size_t>(first_node); i < graph.nodes().size(); ++i) {
    const Node& node = graph.nodes()[i];
    if (std::ranges::count(node.kinds, NodeKind::turning) == 0) continue;
    std::ranges::copy_if(node.wrt, std::back_inserter(kept[node.id]),
                         [&](Parameter p) { return std::ranges::count(wanted, p) > 0; });
  }
  const auto is_unwanted = [&](int id) { return kept.contains(id) && kept[id].empty(); };
  std::vector<Arc> arcs = graph.take_arcs(first_arc);
  while (!arcs.empty()) {
    std::vector<Arc> run = take_run(arcs, is_unwanted);
    if (run.front().from != run.back().to || !is_unwanted(run.front().from)) {
      for (std::size_t i = 1; i < run.size(); ++i) extend(run.front(), run[i]);
      run.resize(1);
    } else {
      for (const Arc& arc : run) kept.erase(arc.from);
    }
    for (Arc& arc : run) graph.add_arc(std::move(arc));
  }
  for (auto& [id, wrt] : kept)
    if (!wrt.empty()) graph.set_turning(id, wrt);
}

}  // namespace exsect
