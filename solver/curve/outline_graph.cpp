#include "curve/outline_graph.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "curve/curve_course.h"
#include "curve/curve_place.h"
#include "curve/surface_graph.h"

namespace exsect {
namespace {

/// Of the rim of what a region leaves of a patch.
class DrawnOutline {
 public:
  DrawnOutline(const SurfaceCurve& common, const RegionOutline& of, const DrawnPatch& patch, double tolerance)
      : outline_(of), common_(common), patch_(patch), tolerance_(tolerance) {
    common_.graph = outline_.graph;
    for (std::size_t i = 0; i < common_.graph.nodes.size(); ++i)
      places_.push_back(place_of(common_.graph, i, place_width(patch, tolerance)));
  }

  GraphBuilder run() {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      Node node = node_at(places_[i], patch_);
      node.bounds = bounds_at(common_, i);
      const std::size_t rims = node.on.size() + node.bounds.size();
      if (rims > 0) node.kinds.push_back(NodeKind::boundary);
      if (rims > 1) node.kinds.push_back(NodeKind::corner);
      builder_.add_node(std::move(node), to_double(places_[i][0].width() + places_[i][1].width()) + 0x1p-53);
    }
    for (const std::size_t arc : outline_.curves) builder_.add_arc(drawn({arc, false}, 0));
    for (const std::size_t node : outline_.points) {
      builder_.add_kind(static_cast<int>(node), NodeKind::touch);
      builder_.add_isolated(static_cast<int>(node));
    }
    for (const RegionPart& part : outline_.parts) add_part(part);
    return std::move(builder_);
  }

 private:
  Arc drawn(const OutlineArc& of, int component) const {
    const CurveBranch& arc = common_.graph.arcs[of.arc];
    const CurveCourse course = curve_course(common_.graph, places_, of.arc, patch_, tolerance_);
    std::vector<PolylineVertex> polyline = polyline_of(course);
    int from = static_cast<int>(arc.from), to = static_cast<int>(arc.to);
    const ArcPlace place = place_of_arc(arc, builder_.node(from), builder_.node(to));
    if (of.is_reversed) {
      std::ranges::reverse(polyline);
      std::swap(from, to);
    }
    return {0, component, from, to, place, Contact::tangential, std::move(polyline), course.error_bound};
  }

  void add_part(const RegionPart& part) {
    std::vector<std::vector<Arc>> chains;
    for (const std::vector<OutlineArc>& chain : part.chains) {
      chains.emplace_back();
      for (const OutlineArc& arc : chain) {
        chains.back().push_back(drawn(arc, -1));
        builder_.add_kind(chains.back().back().from, NodeKind::end_of_overlap);
      }
    }
    builder_.add_overlap(std::move(chains));
  }

  const RegionOutline& outline_;
  SurfaceCurve common_;
  const DrawnPatch& patch_;
  double tolerance_;
  std::vector<NodePlace> places_;
  GraphBuilder builder_;
};

}  // namespace

GraphBuilder outline_graph(const SurfaceCurve& common, const RegionOutline& outline, const DrawnPatch& patch,
                           double tolerance) {
  return DrawnOutline(common, outline, patch, tolerance).run();
}

}  // namespace exsect
