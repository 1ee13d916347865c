#include "intersect_surface.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/bounding_box.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "answer/coarse_drawing.h"
#include "answer/finished_result.h"
#include "answer/graph_builder.h"
#include "answer/placed_result.h"
#include "answer/proof.h"
#include "answer/run.h"
#include "curve/curve_course.h"
#include "curve/curve_place.h"
#include "curve/region_outline.h"
#include "curve/surface_curve.h"
#include "curve/surface_graph.h"
#include "curve/turning_in_v.h"

namespace exsect {
namespace {

/// Of the rim of what a region leaves of a patch.
class DrawnOutline {
 public:
  /// `common` contains the patch.
  DrawnOutline(SurfaceCurve common, const DrawnPatch& patch, double tolerance)
      : outline_(outline(common.region)), common_(std::move(common)), patch_(patch), tolerance_(tolerance) {
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

  RegionOutline outline_;
  SurfaceCurve common_;
  const DrawnPatch& patch_;
  double tolerance_;
  std::vector<NodePlace> places_;
  GraphBuilder builder_;
};

/// The curve of a surface and a patch.
struct KnownCurve {
  SurfaceCurve curve;
  RationalPatch patch;
  std::vector<Parameter> turning;
};

IntersectResult drawn(const KnownCurve& known, const Run& run) {
  const DrawnPatch patch(known.patch);
  const double tolerance = run.drawn_tolerance(patch.extent());
  GraphBuilder builder;
  if (known.curve.contains_patch)
    builder = DrawnOutline(known.curve, patch, tolerance).run();
  else
    builder = surface_graph(known.curve, patch, tolerance);
  IntersectResult result = finished(std::move(builder), {known.turning}, {});
  result.coarse = coarse_drawing(result.graph, run.tolerance(patch.extent()));
  return result;
}

IntersectResult solved(const ImplicitSurface& surface, const RationalPatch& x, const Run& run) {
  KnownCurve known{{}, x.reduced(), {Parameter::u}};
  run.timed("curve", [&] { known.curve = surface_curve(surface, x); });
  if (std::ranges::find(run.turning(), Parameter::v) != run.turning().end()) {
    known.turning.push_back(Parameter::v);
    run.timed("turning", [&] { known.curve.graph = with_turning_in_v(std::move(known.curve.graph)); });
  }
  const auto kept = std::make_shared<const KnownCurve>(std::move(known));
  std::optional<IntersectResult> result;
  run.timed("drawing", [&] {
    result = first_drawn([kept](const Run& given) { return std::optional(drawn(*kept, given)); }, run);
  });
  return *std::move(result);
}

}  // namespace

IntersectResult intersect(const ImplicitSurface& surface, const RationalPatch& x,
                          const IntersectOptions& options) {
  return in_nearest_rounding([&] {
    const Run run(options);
    const BoundingBox box = bounding_box(x);
    const std::array<Point, 2> corners = {box.lower, box.upper};
    const auto place = Placement::of(corners);
    IntersectResult result = run.finished(answered(run, [&] {
      return !place ? solved(surface, x, run)
                    : solved_in_place(place, to_double(model_extent(corners)), run, [&](const Run& about) {
                        return solved(place->placed(surface), place->placed(x), about);
                      });
    }));
    return answer_to(options, std::move(result),
                     [surface, x](const IntersectOptions& other) { return intersect(surface, x, other); });
  });
}

}  // namespace exsect
