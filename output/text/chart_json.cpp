#include "output/text/chart_json.h"

#include <exsect/geometry/natural_parameters.h>

#include "output/text/node_place.h"

namespace exsect::cli {
namespace {

Json chart_json(const ImplicitSurface& surface, const std::array<RationalInterval, 3>& box) {
  const NaturalParameters at = natural_parameters(surface, box);
  Json json = Json::object();
  if (at.turn) json["turn"] = json_interval(*at.turn);
  if (at.height) json["height"] = json_interval(*at.height);
  if (at.tube) json["tube"] = json_interval(*at.tube);
  return json;
}

}  // namespace

void add_charts(Json& json, const IntersectionGraph& graph, const RationalPatch& x,
                const ImplicitSurface& surface) {
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    Json chart = chart_json(surface, space_box(graph.nodes[i].box, x));
    if (!chart.empty()) json["nodes"][i]["chart"] = std::move(chart);
  }
}

void add_charts(Json& json, const SurfaceIntersection& result, const ImplicitSurface& first,
                const ImplicitSurface& second) {
  for (std::size_t i = 0; i < result.nodes.size(); ++i)
    json["nodes"][i]["charts"] =
        Json::array({chart_json(first, result.nodes[i].box), chart_json(second, result.nodes[i].box)});
}

}  // namespace exsect::cli
