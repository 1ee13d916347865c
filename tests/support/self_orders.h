// Graphs of self-intersections with all pairs in one of their two orders, to be compared.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "support/graph_isomorphism.h"

namespace exsect::testing {

/// The pairs of the component in the other order.
inline void exchange(IntersectionGraph& graph, const Component& component) {
  const auto other = [](Parameter p) { return static_cast<Parameter>((index(p) + 2) % 4); };
  std::vector<bool> done(graph.nodes.size(), false);
  for (const int id : component.arcs) {
    Arc& arc = graph.arcs[static_cast<std::size_t>(id)];
    for (PolylineVertex& v : arc.polyline)
      v.parameters = {v.parameters[2], v.parameters[3], v.parameters[0], v.parameters[1]};
    for (const int end : {arc.from, arc.to}) {
      const auto i = static_cast<std::size_t>(end);
      if (done[i]) continue;
      done[i] = true;
      Node& node = graph.nodes[i];
      node.approx = {node.approx[2], node.approx[3], node.approx[0], node.approx[1]};
      node.box = {node.box[2], node.box[3], node.box[0], node.box[1]};
      for (Parameter& p : node.wrt) p = other(p);
      for (Side& side : node.on) side.parameter = other(side.parameter);
    }
  }
}

/// Components in the order of their pairs in which u1 + v1/3 is the smaller one at the node where the two
/// differ most, up to `renaming`, which is then undone by difference().
inline IntersectionGraph normalised(IntersectionGraph graph, const Renaming& renaming = {}) {
  for (const Component& component : graph.components) {
    double most = 0;
    for (const int id : component.arcs)
      for (const int end :
           {graph.arcs[static_cast<std::size_t>(id)].from, graph.arcs[static_cast<std::size_t>(id)].to}) {
        const auto& at = graph.nodes[static_cast<std::size_t>(end)].approx;
        std::array<double, 4> z{};  // in the parameters of the first graph
        for (std::size_t j = 0; j < 4; ++j)
          z[j] = renaming.reversed[j] ? 1 - at[renaming.to[j]] : at[renaming.to[j]];
        const double d = z[0] + z[1] / 3 - z[2] - z[3] / 3;
        most = std::fabs(d) > std::fabs(most) + 1e-9 ? d : most;
      }
    if (most > 0) exchange(graph, component);
  }
  return graph;
}

}  // namespace exsect::testing
