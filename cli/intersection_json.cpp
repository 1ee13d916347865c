#include "intersection_json.h"

#include <algorithm>

namespace exsect::cli {
namespace {

Json names_json(const std::vector<Parameter>& parameters) {
  Json names = Json::array();
  for (Parameter p : parameters) names.push_back(name(p));
  return names;
}

Json node_json(const Node& node) {
  Json json = {{"id", node.id}, {"kinds", Json::array()}};
  for (NodeKind kind : node.kinds) json["kinds"].push_back(name(kind));
  json["on"] = Json::array();
  for (Side side : node.on) json["on"].push_back(side_name(side));
  json["wrt"] = names_json(node.wrt);
  json["free"] = names_json(node.free);
  json["box"] = json_box(node.box);
  json["approx"] = json_approx(node.approx, node.point);
  return json;
}

Json arc_json(const Arc& arc) {
  Json polyline = Json::array();
  for (const PolylineVertex& vertex : arc.polyline) {
    Json row = vertex.parameters;
    for (double coordinate : vertex.point) row.push_back(coordinate);
    polyline.push_back(std::move(row));
  }
  return {{"id", arc.id},
          {"component", arc.component},
          {"from", arc.from},
          {"to", arc.to},
          {"on", name(arc.place)},
          {"contact", name(arc.contact)},
          {"free", names_json(arc.free)},
          {"polyline", std::move(polyline)},
          {"error_bound", decimal_not_below(arc.error_bound)}};
}

Json overlap_json(const Overlap& overlap) {
  Json chains = Json::array();
  for (const std::vector<Arc>& chain : overlap.chains) {
    Json arcs = Json::array();
    for (const Arc& arc : chain) arcs.push_back(arc_json(arc));
    chains.push_back(std::move(arcs));
  }
  return {{"id", overlap.id}, {"chains", std::move(chains)}};
}

Json summary_json(const IntersectionGraph& graph) {
  Json turning = Json::object();
  for (Parameter p : all_parameters) turning[name(p)] = graph.turning_points(p);
  return {{"components", graph.components.size()},
          {"closed", graph.count(ComponentShape::closed)},
          {"open", graph.count(ComponentShape::open)},
          {"branched", graph.count(ComponentShape::branched)},
          {"isolated", graph.isolated_points.size()},
          {"overlaps", graph.overlaps.size()},
          {"turning", std::move(turning)},
          {"boundary", graph.boundary_points()}};
}

template <typename T, typename Form>
Json list(const std::vector<T>& values, Form form) {
  Json json = Json::array();
  for (const T& value : values) json.push_back(form(value));
  return json;
}

}  // namespace

Json intersection_json(const IntersectResult& result, const PatchNames& names) {
  const IntersectionGraph& graph = result.graph;
  Json json = {{"exsect", "intersection/1"},
               {"status", result.status == Status::complete ? "complete" : "incomplete"},
               {"first", names.first},
               {"second", names.second}};
  json["nodes"] = list(graph.nodes, node_json);
  json["arcs"] = list(graph.arcs, arc_json);
  json["components"] = list(graph.components, [](const Component& component) {
    return Json{{"id", component.id}, {"shape", name(component.shape)}, {"arcs", component.arcs}};
  });
  json["isolated_points"] = graph.isolated_points;
  json["overlaps"] = list(graph.overlaps, overlap_json);
  json["summary"] = summary_json(graph);
  json["incomplete"] = list(result.incomplete, [](const Incomplete& region) {
    return Json{{"where", json_box(region.where)}, {"why", region.why}};
  });
  json["work"] = {{"milliseconds", result.work.milliseconds}, {"steps", result.work.steps}};
  return json;
}

}  // namespace exsect::cli
