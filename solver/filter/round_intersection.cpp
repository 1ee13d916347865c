#include "filter/round_intersection.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "filter/round_polyline.h"

namespace exsect {
namespace {

/// A whole one, but for a nappe.
bool is_round(const ImplicitSurface& surface) {
  return surface.data().has_value() && surface.box().clauses.empty();
}

/// Those that belong to the surfaces; empty if that is not known.
std::optional<std::vector<RoundBox>> kept_landmarks(const RoundChart& chart) {
  const std::optional<std::vector<RoundBox>> all = round_landmarks(chart);
  if (!all) return std::nullopt;
  std::vector<RoundBox> kept;
  for (const RoundBox& landmark : *all) {
    const int side = chart.side(landmark);
    if (side == 0) return std::nullopt;
    if (side > 0) kept.push_back(landmark);
  }
  return kept;
}

/// About the size of all.
double extent_of(const RoundChart& chart, const std::vector<RoundBox>& landmarks) {
  double extent = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double least = INFINITY, greatest = -INFINITY;
    for (const RoundBox& landmark : landmarks) {
      const double at = chart.position(landmark)[k].approximation();
      least = std::min(least, at);
      greatest = std::max(greatest, at);
    }
    extent = std::max(extent, greatest - least);
  }
  return std::max(extent, 2 * chart.unit() * kReduced);
}

using DoubleVector = std::array<double, 3>;

DoubleVector edge_from(const DoubleVector& a, const DoubleVector& b) {
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}
double length_of(const DoubleVector& a) { return std::hypot(a[0], a[1], a[2]); }
DoubleVector cross_of(const DoubleVector& a, const DoubleVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double along_of(const DoubleVector& a, const DoubleVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Of some vertices of each arc the one for which a function is greatest.
template <class Size>
DoubleVector farthest(const std::vector<const SpaceArc*>& arcs, const Size& size) {
  DoubleVector best{};
  double greatest = -1;
  for (const SpaceArc* arc : arcs)
    for (std::size_t i = 0; i < arc->polyline.size(); i += 1 + arc->polyline.size() / 32)
      if (const double s = size(arc->polyline[i]); s > greatest) greatest = s, best = arc->polyline[i];
  return best;
}

/// Four points of the curve, within the error of vertices, are certainly not in one plane.
bool leaves_every_plane(const std::vector<const SpaceArc*>& arcs, double error) {
  const DoubleVector start = arcs.front()->polyline.front();
  const DoubleVector a =
      edge_from(start, farthest(arcs, [&](const DoubleVector& v) { return length_of(edge_from(start, v)); }));
  const DoubleVector b = edge_from(start, farthest(arcs, [&](const DoubleVector& v) {
                                     return length_of(cross_of(a, edge_from(start, v)));
                                   }));
  const DoubleVector normal = cross_of(a, b);
  const DoubleVector c = edge_from(start, farthest(arcs, [&](const DoubleVector& v) {
                                     return std::fabs(along_of(normal, edge_from(start, v)));
                                   }));
  // A determinant is at most the product of the lengths, and linear in each.
  double greatest = 1, least = 1;
  for (const DoubleVector& edge : {a, b, c}) {
    greatest *= length_of(edge) + 2 * error;
    least *= length_of(edge);
  }
  return std::fabs(along_of(normal, c)) > (greatest - least + greatest * 0x1p-40) * kSlack;
}

/// Whether no circle is among the common points of a torus and a plane (method, Lemma 17.17). Empty if one of
/// the surfaces is no plane, and there are no such rules.
std::optional<bool> has_no_circle(const ImplicitSurface& first, const ImplicitSurface& second) {
  if (first.kind() == SurfaceKind::plane) return has_no_circle(second, first);
  if (second.kind() != SurfaceKind::plane) return std::nullopt;
  const SurfaceData &torus = *first.data(), &plane = *second.data();
  return dot(torus.axis, plane.axis) != 0 || dot(plane.axis, torus.point - plane.point) != 0;
}

/// Closed curves through the arcs, each of which goes on with the one that begins where it ends. Empty if one
/// of them may be a conic.
std::optional<std::vector<SpaceCurve>> closed_curves(const std::vector<SpaceArc>& arcs,
                                                     std::optional<bool> has_no_conic, double vertex_error) {
  std::vector<SpaceCurve> curves;
  std::vector<bool> is_used(arcs.size(), false);
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (is_used[i]) continue;
    SpaceCurve curve{static_cast<int>(curves.size()), SpaceCurveKind::general, {}, true, 1};
    std::vector<const SpaceArc*> members;
    for (std::size_t k = i; !is_used[k]; k = static_cast<std::size_t>(arcs[k].to)) {
      is_used[k] = true;
      curve.arcs.push_back(static_cast<int>(k));
      members.push_back(&arcs[k]);
    }
    if (!(has_no_conic ? *has_no_conic : leaves_every_plane(members, vertex_error))) return std::nullopt;
    curves.push_back(std::move(curve));
  }
  return curves;
}

SpaceNode joint_at(const RoundChart& chart, const RoundBox& landmark, int id) {
  const std::array<DoubleBall, 3> at = chart.position(landmark);
  SpaceNode node{id, SpaceNodeKind::joint, 2, {}, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    node.box[k] = at[k].interval();
    node.approx[k] = at[k].approximation();
  }
  return node;
}

}  // namespace

std::optional<SurfaceIntersection> round_intersection(const ImplicitSurface& first,
                                                      const ImplicitSurface& second,
                                                      const std::function<double(double)>& tolerance) {
  if (!is_round(first) || !is_round(second)) return std::nullopt;
  const std::optional<RoundChart> chart = RoundChart::of(first, second);
  if (!chart) return std::nullopt;
  const std::optional<std::vector<RoundBox>> landmarks = kept_landmarks(*chart);
  if (!landmarks) return std::nullopt;
  SurfaceIntersection result{Status::complete};
  if (landmarks->empty()) return result;
  const double allowed = tolerance(extent_of(*chart, *landmarks));
  // Arcs run along n2 x n1, or n1 x n2: (17.28).
  const SideSigns beside = chart->is_of_second() ? SideSigns{-1, 1} : SideSigns{1, -1};
  std::vector<int> arrivals(landmarks->size(), 0);
  double vertex_error = 0;
  for (std::size_t i = 0; i < landmarks->size(); ++i) {
    const int id = static_cast<int>(i);
    const std::optional<RoundTrace> trace = round_trace(*chart, *landmarks, i);
    if (!trace) return std::nullopt;
    if (++arrivals[static_cast<std::size_t>(trace->end)] > 1 || trace->end == id) return std::nullopt;
    ArcPolyline polyline = round_polyline(*chart, *trace, allowed);
    const double bound = polyline.bound();
    vertex_error = larger_bound(vertex_error, polyline.vertex_error());
    if (!(bound <= allowed)) return std::nullopt;
    result.nodes.push_back(joint_at(*chart, (*landmarks)[i], id));
    result.arcs.push_back({id, 0, id, trace->end, 1, {}, bound, beside});
    result.arcs.back().polyline.reserve(polyline.size());
    for (const PolylineVertex& vertex : polyline.take_vertices())
      result.arcs.back().polyline.push_back(vertex.point);
  }
  std::optional<std::vector<SpaceCurve>> curves =
      closed_curves(result.arcs, has_no_circle(first, second), vertex_error);
  if (!curves) return std::nullopt;
  result.curves = *std::move(curves);
  for (const SpaceCurve& curve : result.curves)
    for (const int arc : curve.arcs) result.arcs[static_cast<std::size_t>(arc)].curve = curve.id;
  return result;
}

}  // namespace exsect
