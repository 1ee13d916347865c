#include "space_graph.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "infinite.h"

namespace exsect {
namespace {

/// A connected part of the curve while it is run through: from every end of an arc to the other arcs there.
class ArcOrder {
 public:
  explicit ArcOrder(const SurfaceIntersection& found)
      : found_(found), at_node_(found.nodes.size()), seen_(found.arcs.size(), false) {
    for (const SpaceArc& arc : found.arcs)
      for (const int node : {arc.from, arc.to}) at_node_[index_of(node)].push_back(arc.id);
  }

  /// Without arcs where all are seen. An open part begins at one of its ends.
  Component next() {
    Component part{0, ComponentShape::closed, {}};
    const int first = start();
    if (first < 0) return part;
    std::vector<int> waiting = {first};
    while (!waiting.empty()) {
      const int arc = waiting.back();
      waiting.pop_back();
      if (seen_[index_of(arc)]) continue;
      seen_[index_of(arc)] = true;
      part.arcs.push_back(arc);
      for (const int node : ends(arc)) {
        const std::size_t degree = at_node_[index_of(node)].size();
        if (degree > 2) part.shape = ComponentShape::branched;
        if (degree == 1 && part.shape == ComponentShape::closed) part.shape = ComponentShape::open;
        for (const int other : at_node_[index_of(node)]) waiting.push_back(other);
      }
    }
    return part;
  }

 private:
  static std::size_t index_of(int id) { return static_cast<std::size_t>(id); }
  std::array<int, 2> ends(int arc) const {
    return {found_.arcs[index_of(arc)].from, found_.arcs[index_of(arc)].to};
  }

  /// An arc that is not seen, at an end of a part where there is one.
  int start() const {
    int result = -1;
    for (const SpaceArc& arc : found_.arcs) {
      if (seen_[index_of(arc.id)]) continue;
      for (const int node : ends(arc.id))
        if (at_node_[index_of(node)].size() == 1) return arc.id;
      if (result < 0) result = arc.id;
    }
    return result;
  }

  const SurfaceIntersection& found_;
  std::vector<std::vector<int>> at_node_;  // a loop is there twice
  std::vector<bool> seen_;
};

Node node_in_space(const SpaceNode& node) {
  Node result{node.id, {}, {}, {}, {}, {}, node.approx};
  if (node.kind == SpaceNodeKind::touch) result.kinds = {NodeKind::touch};
  if (node.kind == SpaceNodeKind::crossing) result.kinds = {NodeKind::crossing};
  return result;
}

Arc arc_in_space(const SpaceArc& arc) {
  Arc result{arc.id,
             -1,
             arc.from,
             arc.to,
             ArcPlace::interior,
             arc.multiplicity != 1 ? Contact::tangential : Contact::transversal,
             {},
             arc.error_bound};
  for (const std::array<double, 3>& point : arc.polyline) result.polyline.push_back({{}, point});
  return result;
}

}  // namespace

IntersectResult graph_in_space(const SurfaceIntersection& found) {
  IntersectResult result{found.status, {}, {}, found.work};
  IntersectionGraph& graph = result.graph;
  for (const SpaceNode& node : found.nodes) {
    graph.nodes.push_back(node_in_space(node));
    if (node.kind == SpaceNodeKind::touch) graph.isolated_points.push_back(node.id);
  }
  for (const SpaceArc& arc : found.arcs) graph.arcs.push_back(arc_in_space(arc));
  ArcOrder order(found);
  for (Component part = order.next(); !part.arcs.empty(); part = order.next()) {
    part.id = static_cast<int>(graph.components.size());
    for (const int arc : part.arcs) graph.arcs[static_cast<std::size_t>(arc)].component = part.id;
    graph.components.push_back(std::move(part));
  }
  for (const OpenQuestion& open : found.incomplete) result.incomplete.push_back({{}, open.why, open.reason});
  return result;
}

std::vector<double> point_bounds(const SurfaceIntersection& found) {
  std::vector<double> bounds;
  for (const SpaceNode& node : found.nodes) {
    if (node.kind != SpaceNodeKind::touch) continue;
    double bound = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational at = from_double(node.approx[k]);
      bound += to_double(std::max<Rational>(abs(node.box[k].lower - at), abs(node.box[k].upper - at)));
    }
    bounds.push_back(bound * kSlack + kUnderflowLoss);
  }
  return bounds;
}

double extent_in_space(const SurfaceIntersection& found) {
  std::array<double, 3> lower = {infinite, infinite, infinite}, upper = {-infinite, -infinite, -infinite};
  const auto cover = [&](const std::array<double, 3>& point) {
    for (std::size_t k = 0; k < 3; ++k) {
      lower[k] = std::min(lower[k], point[k]);
      upper[k] = std::max(upper[k], point[k]);
    }
  };
  for (const SpaceNode& node : found.nodes) cover(node.approx);
  for (const SpaceArc& arc : found.arcs) std::ranges::for_each(arc.polyline, cover);
  double extent = 0;
  for (std::size_t k = 0; k < 3; ++k) extent = std::max(extent, upper[k] - lower[k]);
  return extent;
}

double largest_bound(const SurfaceIntersection& found) {
  double bound = 0;
  for (const SpaceArc& arc : found.arcs) bound = std::max(bound, arc.error_bound);
  return bound;
}

}  // namespace exsect
