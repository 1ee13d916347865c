#include "lift/surface_intersection.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace exsect {

const char* name(SpaceNodeKind kind) {
  constexpr std::array<const char*, 6> names = {"joint", "cut", "end", "touch", "crossing", "singular"};
  return names[static_cast<std::size_t>(kind)];
}

const char* name(SpaceCurveKind kind) {
  constexpr std::array<const char*, 6> names = {"line",     "circle",    "ellipse",
                                                "parabola", "hyperbola", "general"};
  return names[static_cast<std::size_t>(kind)];
}

void append(SurfaceIntersection& to, SurfaceIntersection part) {
  const auto nodes = static_cast<int>(to.nodes.size()), arcs = static_cast<int>(to.arcs.size()),
             curves = static_cast<int>(to.curves.size());
  for (SpaceNode& node : part.nodes) {
    node.id += nodes;
    to.nodes.push_back(std::move(node));
  }
  for (SpaceArc& arc : part.arcs) {
    arc.id += arcs;
    arc.curve += curves;
    arc.from += nodes;
    arc.to += nodes;
    to.arcs.push_back(std::move(arc));
  }
  for (SpaceCurve& curve : part.curves) {
    curve.id += curves;
    for (int& arc : curve.arcs) arc += arcs;
    to.curves.push_back(std::move(curve));
  }
  if (part.status == Status::incomplete) to.status = Status::incomplete;
  std::ranges::move(part.incomplete, std::back_inserter(to.incomplete));
}

int SurfaceIntersection::count(SpaceNodeKind kind) const {
  return static_cast<int>(
      std::count_if(nodes.begin(), nodes.end(), [&](const SpaceNode& node) { return node.kind == kind; }));
}

int SurfaceIntersection::count(SpaceCurveKind kind) const {
  return static_cast<int>(std::count_if(curves.begin(), curves.end(),
                                        [&](const SpaceCurve& curve) { return curve.kind == kind; }));
}

}  // namespace exsect
