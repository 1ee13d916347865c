#include "output/drawing/surfaces_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace exsect::cli {
namespace {

constexpr std::array<double, 4> none = {no_parameter, no_parameter, no_parameter, no_parameter};

unsigned kinds_of(SpaceNodeKind kind) {
  const auto bit = [](NodeKind k) { return 1U << static_cast<unsigned>(k); };
  if (kind == SpaceNodeKind::touch) return bit(NodeKind::touch);
  return kind == SpaceNodeKind::crossing ? bit(NodeKind::crossing) : 0;
}

SceneCurve scene_curve(const SpaceArc& arc, const SurfaceIntersection& result) {
  const SpaceCurve& curve = result.curves.at(static_cast<std::size_t>(arc.curve));
  SceneCurve shown{fmt::format("arc {} {} {}", arc.id, name(curve.kind), curve.id),
                   arc.id,
                   arc.curve,
                   -1,
                   ArcPlace::interior,
                   arc.multiplicity != 1 ? Contact::tangential : Contact::transversal,
                   arc.error_bound,
                   {}};
  for (const std::array<double, 3>& point : arc.polyline) shown.vertices.push_back({none, point});
  return shown;
}

}  // namespace

SpacePoints drawn_points(const DrawnSurfaces& drawn) {
  SpacePoints points;
  for (const SpaceArc& arc : drawn.result.arcs)
    points.insert(points.end(), arc.polyline.begin(), arc.polyline.end());
  for (const SpaceNode& node : drawn.result.nodes) points.push_back(node.approx);
  for (const ImplicitSurface* surface : {&drawn.first, &drawn.second})
    std::ranges::move(extreme_points(*surface), std::back_inserter(points));
  return points;
}

Scene surfaces_scene(const DrawnSurfaces& drawn, const std::string& title, int cells) {
  Scene scene{title, pair_names, {}, {}, {}};
  const SpacePoints around = drawn_points(drawn);
  const auto add = [&](const ImplicitSurface& surface, const std::string& name) {
    if (std::optional<SceneMesh> mesh = sampled(surface, name, around, cells))
      scene.meshes.push_back(std::move(*mesh));
  };
  add(drawn.first, drawn.names.first);
  add(drawn.second, drawn.names.second);
  for (const SpaceArc& arc : drawn.result.arcs) scene.curves.push_back(scene_curve(arc, drawn.result));
  for (const SpaceNode& node : drawn.result.nodes)
    scene.nodes.push_back({fmt::format("node {} {}", node.id, name(node.kind)),
                           node.id,
                           kinds_of(node.kind),
                           {none, node.approx}});
  return scene;
}

}  // namespace exsect::cli
