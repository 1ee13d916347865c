#include "output/text/node_csv.h"

#include <exsect/geometry/number.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "output/text/json_forms.h"
#include "output/text/shown_line.h"
#include "output/text/surfaces_output.h"

namespace exsect::cli {
namespace {

std::string box_heads(const ParameterNames& names) {
  std::string heads;
  for (const Parameter p : named_parameters(names))
    heads += fmt::format(",{0}_lower,{0}_upper", name(p, names));
  for (const Parameter p : named_parameters(names)) heads += fmt::format(",{}", name(p, names));
  return heads + ",x,y,z\n";
}

std::string box_cells(const ParameterBox& box, const std::array<double, 4>& approx,
                      const std::array<double, 3>& point, const ParameterNames& names) {
  std::string cells;
  for (const Parameter p : named_parameters(names))
    cells += "," + to_string(box[index(p)].lower) + "," + to_string(box[index(p)].upper);
  for (const Parameter p : named_parameters(names)) cells += fmt::format(",{}", approx[index(p)]);
  for (double coordinate : point) cells += fmt::format(",{}", coordinate);
  return cells + "\n";
}

template <typename T, typename Text>
std::string blank_separated(const std::vector<T>& values, Text text) {
  std::string joined;
  for (const T& value : values) joined += (joined.empty() ? "" : " ") + std::string(text(value));
  return joined;
}

}  // namespace

std::string node_csv(const IntersectionGraph& graph, const ParameterNames& names) {
  const auto parameter = [&](Parameter p) { return name(p, names); };
  std::string text = "id,kinds,on,wrt,free" + box_heads(names);
  for (const Node& node : graph.nodes) {
    std::vector<std::string> places = node.bounds;
    std::ranges::transform(node.on, std::inserter(places, places.begin()),
                           [&](Side side) { return side_name(side, names); });
    text += fmt::format("{},{},{},{},{}", node.id,
                        blank_separated(node.kinds, [](NodeKind kind) { return name(kind); }),
                        blank_separated(places, [](const std::string& place) { return place; }),
                        blank_separated(node.wrt, parameter), blank_separated(node.free, parameter));
    text += box_cells(node.box, node.approx, node.point, names);
  }
  return text;
}

std::string point_csv(const LineIntersection& line, const RationalPatch& x) {
  std::string text = "id,on,multiplicity,branch" + box_heads(pair_names);
  int id = 0;
  for (const ShownPoint& shown : shown_points(line.solution, x)) {
    text += fmt::format("{},{},{},{}", id++,
                        blank_separated(shown.point.sides(), [](Side side) { return side_name(side); }),
                        shown.point.multiplicity(), shown.point.branch());
    text += box_cells(shown.point.box(), shown.parameters, shown.space, pair_names);
  }
  return text;
}

std::string space_node_csv(const SurfaceIntersection& result) {
  std::string text = "id,kind,arcs,on,x_lower,x_upper,y_lower,y_upper,z_lower,z_upper,x,y,z\n";
  for (const SpaceNode& node : result.nodes) {
    text += fmt::format("{},{},{},{}", node.id, name(node.kind), node.degree, bounds_text(node));
    for (const RationalInterval& side : node.box)
      text += "," + to_string(side.lower) + "," + to_string(side.upper);
    for (double coordinate : node.approx) text += fmt::format(",{}", coordinate);
    text += "\n";
  }
  return text;
}

}  // namespace exsect::cli
