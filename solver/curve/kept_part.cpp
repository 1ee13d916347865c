#include "curve/kept_part.h"

#include <vector>

namespace exsect {

CurveGraph kept_part(CurveGraph graph, const PlacedRegion& region) {
  if (region.is_plane()) return graph;
  CurveGraph kept{{}, {}, graph.swept, graph.factors, graph.values, graph.columns, false};
  std::vector<std::size_t> arc_position(graph.arcs.size(), CurveGraph::dropped);
  std::vector<bool> is_kept(graph.nodes.size(), false);
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    is_kept[i] = graph.nodes[i].exact && region.contains(*graph.nodes[i].exact);
  for (std::size_t i = 0; i < graph.arcs.size(); ++i) {
    const CurveBranch& arc = graph.arcs[i];
    CurveNode &from = graph.nodes[arc.from], &to = graph.nodes[arc.to];
    if (region.contains(arc.inside)) {
      is_kept[arc.from] = is_kept[arc.to] = true;
      arc_position[i] = kept.arcs.size();
      kept.arcs.push_back(arc);
    } else if (from.u == to.u) {
      --from.vertical;
      --to.vertical;
    } else {
      --from.right;
      --to.left;
    }
  }
  std::vector<std::size_t> position(graph.nodes.size(), 0);
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    position[i] = kept.nodes.size();
    if (is_kept[i]) kept.nodes.push_back(graph.nodes[i]);
  }
  for (CurveBranch& arc : kept.arcs) {
    arc.from = position[arc.from];
    arc.to = position[arc.to];
  }
  for (CurveColumn& column : kept.columns)
    for (std::size_t& arc : column) arc = arc_position[arc];
  return kept;
}

}  // namespace exsect
