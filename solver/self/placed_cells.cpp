#include "self/placed_cells.h"

#include <algorithm>

namespace exsect {
namespace {

using Ranges = std::array<RationalInterval, 4>;

bool is_side_of_square(const Ranges& cells, const Side& side) {
  const RationalInterval& range = cells[index(side.parameter)];
  return side.value == 0 ? range.lower == 0 : range.upper == 1;
}

double placed_parameter(const RationalInterval& range, double t) {
  if (t == 0) return to_double(range.lower);
  if (t == 1) return to_double(range.upper);
  return to_double(range.lower) + t * to_double(range.width());
}

std::array<double, 4> placed_parameters(const Ranges& cells, const std::array<double, 4>& at) {
  std::array<double, 4> result;
  for (std::size_t j = 0; j < 4; ++j) result[j] = placed_parameter(cells[j], at[j]);
  return result;
}

PlacedNode placed_node(const Ranges& cells, const Node& node) {
  PlacedNode result{node, {}, 0};
  result.node.on.clear();
  for (const Side& side : node.on) {
    const std::size_t j = index(side.parameter);
    if (is_side_of_square(cells, side)) {
      result.node.on.push_back(side);
    } else {
      result.cuts.push_back({j, side.value == 0 ? cells[j].lower : cells[j].upper, side.value == 1});
    }
  }
  for (std::size_t j = 0; j < 4; ++j) {
    RationalInterval& at = result.node.box[j];
    at = {cells[j].lower + at.lower * cells[j].width(), cells[j].lower + at.upper * cells[j].width()};
  }
  result.node.approx = placed_parameters(cells, node.approx);
  return result;
}

/// An arc on sides of cells that is on none of the square, or may be: a pole, where one parameter is free,
/// does not tell on which sides its arcs are.
bool lies_on_cut(const Arc& arc, const std::vector<PlacedNode>& nodes) {
  if (arc.place != ArcPlace::patch_boundary) return false;
  const std::vector<Side>& from = nodes[static_cast<std::size_t>(arc.from)].node.on;
  const std::vector<Side>& to = nodes[static_cast<std::size_t>(arc.to)].node.on;
  const auto is_pole = [&](int end) { return !nodes[static_cast<std::size_t>(end)].node.free.empty(); };
  if (is_pole(arc.from)) return is_pole(arc.to) || to.empty();
  if (is_pole(arc.to)) return from.empty();
  return std::ranges::none_of(from, [&](const Side& side) { return std::ranges::count(to, side) > 0; });
}

}  // namespace

PlacedCells placed_cells(const CellTree& tree, const SolvedCells& solved) {
  const ParameterRectangle &first = tree[solved.first].where, &second = tree[solved.second].where;
  const Ranges cells = {first.u, first.v, second.u, second.v};
  PlacedCells result;
  for (const Node& node : solved.graph.nodes) result.nodes.push_back(placed_node(cells, node));
  for (Arc arc : solved.graph.arcs) {
    for (PolylineVertex& vertex : arc.polyline)
      vertex.parameters = placed_parameters(cells, vertex.parameters);
    for (const int end : {arc.from, arc.to}) ++result.nodes[static_cast<std::size_t>(end)].arcs;
    result.along_cut = result.along_cut || lies_on_cut(arc, result.nodes);
    result.arcs.push_back(std::move(arc));
  }
  result.isolated = solved.graph.isolated_points;
  return result;
}

}  // namespace exsect
