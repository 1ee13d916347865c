#include "curve/surface_graph.h"

#include <algorithm>
#include <utility>

#include "answer/parameter_box.h"
#include "curve/curve_place.h"
#include "curve/curve_sides.h"

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

bool turns(const CurveNode& node) {
  return !node.is_singular && !node.is_on_side && node.vertical == 0 && (node.left == 2 || node.right == 2);
}

bool lie_on_one_side(const Node& a, const Node& b) {
  return std::any_of(a.on.begin(), a.on.end(), [&](const Side& side) {
    return std::find(b.on.begin(), b.on.end(), side) != b.on.end();
  });
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

}  // namespace

std::vector<NodeKind> kinds_of(const CurveNode& at, const Node& node) {
  std::vector<NodeKind> kinds;
  const std::size_t rims = node.on.size() + node.bounds.size();
  if (rims > 0) kinds.push_back(NodeKind::boundary);
  if (rims > 1) kinds.push_back(NodeKind::corner);
  if (!node.wrt.empty()) kinds.push_back(NodeKind::turning);
  const bool begins = at.degree() == 1 && rims == 0;  // in the apex of one nappe
  if (begins)
    kinds.push_back(NodeKind::cusp);
  else if (at.is_singular)
    kinds.push_back(singular_kind(static_cast<std::size_t>(at.degree()), rims == 0));
  return kinds;
}

Node node_at(const NodePlace& place, const DrawnPatch& patch) {
  const std::array<double, 4> approx = {to_double(place[0].midpoint()), to_double(place[1].midpoint()), 0, 0};
  const DrawnPoint point = patch.at(DoubleBall(approx[0]), DoubleBall(approx[1]));
  return {0, {}, sides_of(place), {}, box_of(place), approx, point.point};
}

std::vector<PolylineVertex> polyline_of(const CurveCourse& course) {
  std::vector<PolylineVertex> polyline;
  for (std::size_t i = 0; i < course.points.size(); ++i)
    polyline.push_back({{course.parameters[i][0], course.parameters[i][1], 0, 0}, course.points[i]});
  return polyline;
}

/// The arc lies on a side: on a line of the square through its nodes on which its inner point lies.
ArcPlace place_of_arc(const CurveBranch& arc, const Node& from, const Node& to) {
  const RationalInterval v = arc.inside.r_interval();
  const RealAlgebraic& u = arc.inside.s();
  const bool on_v = v.lower == v.upper && (v.lower == 0 || v.lower == 1);
  const bool on_u = u == RealAlgebraic(0) || u == RealAlgebraic(1);
  return (on_u || on_v) && lie_on_one_side(from, to) ? ArcPlace::patch_boundary : ArcPlace::interior;
}

GraphBuilder surface_graph(const SurfaceCurve& common, const DrawnPatch& patch, double tolerance) {
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

}  // namespace exsect
