#include "answer/intersection_graph.h"

#include <algorithm>

namespace exsect {

int IntersectionGraph::count(ComponentShape shape) const {
  return static_cast<int>(std::count_if(components.begin(), components.end(),
                                        [&](const Component& c) { return c.shape == shape; }));
}

int IntersectionGraph::turning_points(Parameter p) const {
  return static_cast<int>(std::count_if(nodes.begin(), nodes.end(), [&](const Node& n) {
    return std::count(n.wrt.begin(), n.wrt.end(), p) > 0;
  }));
}

int IntersectionGraph::boundary_points() const {
  return static_cast<int>(std::count_if(nodes.begin(), nodes.end(), [](const Node& n) {
    return std::count(n.kinds.begin(), n.kinds.end(), NodeKind::boundary) > 0;
  }));
}

const char* name(NodeKind kind) {
  constexpr std::array<const char*, 7> names = {"boundary", "turning", "corner",        "touch",
                                                "crossing", "cusp",    "end-of-overlap"};
  return names[static_cast<std::size_t>(kind)];
}

const char* name(ArcPlace place) { return place == ArcPlace::interior ? "interior" : "patch-boundary"; }

const char* name(Contact contact) { return contact == Contact::transversal ? "transversal" : "tangential"; }

const char* name(ComponentShape shape) {
  constexpr std::array<const char*, 3> names = {"open", "closed", "branched"};
  return names[static_cast<std::size_t>(shape)];
}

}  // namespace exsect
