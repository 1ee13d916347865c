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
#include "answer/parameter_box.h"
#include "answer/placed_result.h"
#include "answer/proof.h"
#include "answer/proof_failure.h"
#include "answer/run.h"
#include "curve/curve_course.h"
#include "curve/curve_place.h"
#include "curve/curve_sides.h"
#include "curve/region_outline.h"
#include "curve/surface_curve.h"
#include "curve/turning_in_v.h"

namespace exsect {
namespace {

ParameterBox box_of(const NodePlace& place) { return {place[0], place[1], {0, 0}, {0, 0}}; }

std::vector<Side> sides_of(const NodePlace& place) {
  std::vector<Side> sides;
  for (const Parameter p : {Parameter::u, Parameter::v})
    for (const int value : {0, 1}) {
      const RationalInterval& at = place[index(p)];
      if (at.lower == value && at.upper == value) sides.push_back({p, value});
    }
  return sides;
}

Node node_at(const NodePlace& place, const DrawnPatch& patch) {
  const std::array<double, 4> approx = {to_double(place[0].midpoint()), to_double(place[1].midpoint()), 0, 0};
  const DrawnPoint point = patch.at(DoubleBall(approx[0]), DoubleBall(approx[1]));
  return {0, {}, sides_of(place), {}, box_of(place), approx, point.point};
}

std::vector<NodeKind> kinds_of(const CurveNode& at, const Node& node) {
  std::vector<NodeKind> kinds;
  const std::size_t rims = node.on.size() + node.bounds.size();
  if (rims > 0) kinds.push_back(NodeKind::boundary);
  if (rims > 1) kinds.push_back(NodeKind::corner);
  if (!node.wrt.empty()) kinds.push_back(NodeKind::turning);
  const bool begins = at.degree() == 1 && rims == 0;  // in the apex of one nappe
  if (at.is_singular || begins)
    kinds.push_back(at.degree() == 0                                    ? NodeKind::touch
                    : at.degree() > 2 || (at.degree() == 2 && rims > 0) ? NodeKind::crossing
                                                                        : NodeKind::cusp);
  return kinds;
}

bool turns(const CurveNode& node) {
  return !node.is_singular && !node.is_on_side && node.vertical == 0 && (node.left == 2 || node.right == 2);
}

std::vector<PolylineVertex> polyline_of(const CurveCourse& course) {
  std::vector<PolylineVertex> polyline;
  for (std::size_t i = 0; i < course.points.size(); ++i)
    polyline.push_back({{course.parameters[i][0], course.parameters[i][1], 0, 0}, course.points[i]});
  return polyline;
}

bool lie_on_one_side(const Node& a, const Node& b) {
  return std::any_of(a.on.begin(), a.on.end(), [&](const Side& side) {
    return std::find(b.on.begin(), b.on.end(), side) != b.on.end();
  });
}

/// The arc lies on a side: on a line of the square through its nodes on which its inner point lies.
ArcPlace place_of_arc(const CurveBranch& arc, const Node& from, const Node& to) {
  const RationalInterval v = arc.inside.r_interval();
  const RealAlgebraic& u = arc.inside.s();
  const bool on_v = v.lower == v.upper && (v.lower == 0 || v.lower == 1);
  const bool on_u = u == RealAlgebraic(0) || u == RealAlgebraic(1);
  return (on_u || on_v) && lie_on_one_side(from, to) ? ArcPlace::patch_boundary : ArcPlace::interior;
}

/// Beyond a bound, as in the apex of a cone of one nappe, there may be more of the curve: the equation has no
/// sign around the node.
bool is_on_rim(const PlacedRegion& region, const CurveNode& node) {
  return !region.is_plane() && !(node.exact && region.place_of(*node.exact) == RegionPlace::inside);
}

void add_nodes(GraphBuilder& builder, const SurfaceCurve& common, const std::vector<NodePlace>& places,
               const DrawnPatch& patch) {
  const CurveGraph& curve = common.graph;
  const PlacedRegion region(common.region);
  for (std::size_t i = 0; i < curve.nodes.size(); ++i) {
    Node node = node_at(places[i], patch);
    if (turns(curve.nodes[i])) node.wrt = {Parameter::u};
    if (curve.nodes[i].turns_in_v) node.wrt = {Parameter::v};
    node.bounds = bounds_at(common, i);
    node.kinds = kinds_of(curve.nodes[i], node);
    if (curve.nodes[i].degree() == 0 && !is_on_rim(region, curve.nodes[i]))
      node.around = sign_around(common.section, curve.nodes[i]);
    const Rational width = std::max<Rational>(places[i][0].width(), places[i][1].width());
    const int id = builder.add_node(std::move(node), to_double(width) + 0x1p-53);
    if (curve.nodes[i].degree() == 0) builder.add_isolated(id);
  }
}

GraphBuilder drawn_graph(const SurfaceCurve& common, const DrawnPatch& patch, double tolerance) {
  const CurveGraph& curve = common.graph;
  std::vector<NodePlace> places;
  for (std::size_t i = 0; i < curve.nodes.size(); ++i)
    places.push_back(place_of(curve, i, place_width(patch, tolerance)));
  GraphBuilder builder;
  add_nodes(builder, common, places, patch);
  for (std::size_t i = 0; i < curve.arcs.size(); ++i) {
    const CurveBranch& arc = curve.arcs[i];
    const CurveCourse course = curve_course(curve, places, i, patch, tolerance);
    const int from = static_cast<int>(arc.from), to = static_cast<int>(arc.to);
    builder.add_arc({0,
                     0,
                     from,
                     to,
                     place_of_arc(arc, builder.node(from), builder.node(to)),
                     arc.multiplicity > 1 ? Contact::tangential : Contact::transversal,
                     polyline_of(course),
                     course.error_bound,
                     {},
                     signs_beside(common.section, curve, arc)});
  }
  return builder;
}

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
    builder = drawn_graph(known.curve, patch, tolerance);
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
