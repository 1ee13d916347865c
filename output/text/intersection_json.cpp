#include "output/text/intersection_json.h"

#include <algorithm>

namespace exsect::cli {
namespace {

Json names_json(const std::vector<Parameter>& parameters, const ParameterNames& names) {
  Json json = Json::array();
  for (Parameter p : parameters) json.push_back(name(p, names));
  return json;
}

Json node_json(const Node& node, const ParameterNames& names) {
  Json json = {{"id", node.id}, {"kinds", Json::array()}};
  for (NodeKind kind : node.kinds) json["kinds"].push_back(name(kind));
  json["on"] = Json::array();
  for (Side side : node.on) json["on"].push_back(side_name(side, names));
  json["wrt"] = names_json(node.wrt, names);
  json["free"] = names_json(node.free, names);
  json["box"] = json_box(node.box, names);
  json["approx"] = json_approx(node.approx, node.point, names);
  if (node.around) json["around"] = *node.around;
  if (!node.bounds.empty()) json["bounds"] = node.bounds;
  return json;
}

Json arc_json(const Arc& arc, const ParameterNames& names) {
  Json polyline = Json::array();
  for (const PolylineVertex& vertex : arc.polyline) {
    Json row = Json::array();
    for (Parameter p : named_parameters(names)) row.push_back(vertex.parameters[index(p)]);
    for (double coordinate : vertex.point) row.push_back(coordinate);
    polyline.push_back(std::move(row));
  }
  Json json = {{"id", arc.id},
               {"component", arc.component},
               {"from", arc.from},
               {"to", arc.to},
               {"on", name(arc.place)},
               {"contact", name(arc.contact)},
               {"free", names_json(arc.free, names)},
               {"polyline", std::move(polyline)},
               {"error_bound", decimal_not_below(arc.error_bound)}};
  if (arc.beside) {
    json["left"] = arc.beside->left;
    json["right"] = arc.beside->right;
  }
  return json;
}

Json overlap_json(const Overlap& overlap, const ParameterNames& names) {
  Json chains = Json::array();
  for (const std::vector<Arc>& chain : overlap.chains) {
    Json arcs = Json::array();
    for (const Arc& arc : chain) arcs.push_back(arc_json(arc, names));
    chains.push_back(std::move(arcs));
  }
  Json json = {{"id", overlap.id}, {"chains", std::move(chains)}};
  if (overlap.normals) json["normals"] = *overlap.normals;
  return json;
}

template <typename T, typename Form>
Json list(const std::vector<T>& values, Form form) {
  Json json = Json::array();
  for (const T& value : values) json.push_back(form(value));
  return json;
}

}  // namespace

Json summary_json(const IntersectionGraph& graph, const ParameterNames& names) {
  Json turning = Json::object();
  for (Parameter p : named_parameters(names)) turning[name(p, names)] = graph.turning_points(p);
  return {{"components", graph.components.size()},
          {"closed", graph.count(ComponentShape::closed)},
          {"open", graph.count(ComponentShape::open)},
          {"branched", graph.count(ComponentShape::branched)},
          {"isolated", graph.isolated_points.size()},
          {"overlaps", graph.overlaps.size()},
          {"turning", std::move(turning)},
          {"boundary", graph.boundary_points()}};
}

Json incomplete_json(const std::vector<Incomplete>& incomplete, const ParameterNames& names) {
  return list(incomplete, [&](const Incomplete& region) {
    return Json{
        {"where", json_box(region.where, names)}, {"why", region.why}, {"reason", name(region.reason)}};
  });
}

namespace {

/// Everything after the names of the patches.
Json& append_result(Json& json, const IntersectResult& result, const ParameterNames& names) {
  const IntersectionGraph& graph = result.graph;
  json["nodes"] = list(graph.nodes, [&](const Node& node) { return node_json(node, names); });
  json["arcs"] = list(graph.arcs, [&](const Arc& arc) { return arc_json(arc, names); });
  json["components"] = list(graph.components, [](const Component& component) {
    return Json{{"id", component.id}, {"shape", name(component.shape)}, {"arcs", component.arcs}};
  });
  json["isolated_points"] = graph.isolated_points;
  json["overlaps"] =
      list(graph.overlaps, [&](const Overlap& overlap) { return overlap_json(overlap, names); });
  json["summary"] = summary_json(graph, names);
  json["incomplete"] = incomplete_json(result.incomplete, names);
  if (result.coarse)
    json["coarse"] = {{"tolerance", result.coarse->tolerance},
                      {"bound", decimal_not_below(result.coarse->bound)}};
  json["work"] = {{"milliseconds", result.work.milliseconds}, {"steps", result.work.steps}};
  return json;
}

const char* status_name(const IntersectResult& result) {
  return result.status == Status::complete ? "complete" : "incomplete";
}

}  // namespace

Json intersection_json(const IntersectResult& result, const PatchNames& names) {
  Json json = {{"exsect", "intersection/1"},
               {"status", status_name(result)},
               {"first", names.first},
               {"second", names.second}};
  if (!names.equation.empty()) json["equation"] = names.equation;
  return append_result(json, result, names.parameters);
}

Json self_json(const IntersectResult& result, const std::string& patch) {
  Json json = {{"exsect", "self/1"}, {"status", status_name(result)}, {"patch", patch}};
  return append_result(json, result, self_names);
}

}  // namespace exsect::cli
