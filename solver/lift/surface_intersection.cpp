#include "lift/surface_intersection.h"

#include <algorithm>

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

int SurfaceIntersection::count(SpaceNodeKind kind) const {
  return static_cast<int>(
      std::count_if(nodes.begin(), nodes.end(), [&](const SpaceNode& node) { return node.kind == kind; }));
}

int SurfaceIntersection::count(SpaceCurveKind kind) const {
  return static_cast<int>(std::count_if(curves.begin(), curves.end(),
                                        [&](const SpaceCurve& curve) { return curve.kind == kind; }));
}

}  // namespace exsect
