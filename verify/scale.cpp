#include "scale.h"

#include <exsect/algebra/rounding_bounds.h>
#include <exsect/geometry/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "infinite.h"

namespace exsect {
namespace {

Rational largest_of(const BoundingBox& box) {
  Rational most = 0;
  for (const Point& p : {box.lower, box.upper})
    for (const Rational& c : p) most = std::max(most, Rational(abs(c)));
  return most;
}

void scale_down(Arc& arc, int e) {
  for (PolylineVertex& vertex : arc.polyline)
    for (double& c : vertex.point) c = std::ldexp(c, -e);
  arc.error_bound = std::ldexp(arc.error_bound, -e) + kUnderflowLoss;
}

void scale_down(std::array<double, 3>& point, int e) {
  for (double& c : point) {
    c = std::ldexp(c, -e);
    if (!(std::fabs(c) <= max_candidate_number))
      throw std::invalid_argument("a coordinate of the candidate is 2^500 times larger than the model");
  }
}

void scale_up(DistanceEnclosure& distance, int e) {
  distance.lower = std::nextafter(std::ldexp(distance.lower, e), 0);
  distance.upper = std::nextafter(std::ldexp(distance.upper, e), infinite);
}

}  // namespace

double largest_coordinate(const IntersectionGraph& graph) {
  double most = 0;
  for (const Node& node : graph.nodes) most = std::max(most, largest(node.point));
  for (const Arc& arc : graph.arcs)
    for (const PolylineVertex& vertex : arc.polyline) most = std::max(most, largest(vertex.point));
  return most;
}

double largest_coordinate(const Candidate& candidate) {
  double most = 0;
  for (const CandidateCurve& curve : candidate.curves)
    if (curve.space)
      for (const auto& point : curve.space->points) most = std::max(most, largest(point));
  for (const CandidatePoint& point : candidate.points)
    if (point.point) most = std::max(most, largest(*point.point));
  return most;
}

int exponent_of_size(const std::array<ComparedSurface, 2>& surfaces, const IntersectionGraph& graph) {
  Rational most = -1;
  for (const ComparedSurface& surface : surfaces)
    if (const auto* patch = std::get_if<RationalPatch>(&surface))
      most = std::max(most, largest_of(bounding_box(*patch)));
  if (most < 0) most = from_double(largest_coordinate(graph));
  if (most == 0) return 0;
  const auto bits = [](const Integer& n) { return static_cast<int>(msb(n)); };
  const int e = bits(numerator(most)) - bits(denominator(most));
  return std::abs(e) <= 200 ? 0 : e;
}

namespace {

RationalPatch patch_scaled_down(const RationalPatch& x, int e) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (int i = 0; i <= x.degree_u(); ++i) {
    net.emplace_back();
    for (int j = 0; j <= x.degree_v(); ++j) {
      HomogeneousPoint p = x.homogeneous(i, j);
      for (std::size_t k = 0; k < 3; ++k) p[k] *= power_of_two(-e);
      net.back().push_back(p);
    }
  }
  return RationalPatch::from_homogeneous(net);
}

}  // namespace

ComparedSurface scaled_down(const ComparedSurface& surface, int e) {
  if (const auto* patch = std::get_if<RationalPatch>(&surface)) return patch_scaled_down(*patch, e);
  return std::get<ImplicitSurface>(surface).seen_from({0, 0, 0}, power_of_two(e));
}

IntersectResult scaled_down(IntersectResult exact, int e) {
  for (Node& node : exact.graph.nodes)
    for (double& c : node.point) c = std::ldexp(c, -e);
  for (Arc& arc : exact.graph.arcs) scale_down(arc, e);
  for (Overlap& overlap : exact.graph.overlaps)
    for (auto& loop : overlap.chains)
      for (Arc& arc : loop) scale_down(arc, e);
  return exact;
}

Candidate scaled_down(Candidate candidate, int e) {
  for (CandidateCurve& curve : candidate.curves)
    if (curve.space)
      for (auto& point : curve.space->points) scale_down(point, e);
  for (CandidatePoint& point : candidate.points)
    if (point.point) scale_down(*point.point, e);
  return candidate;
}

Verdict scaled_up(Verdict verdict, int e) {
  verdict.tolerance = std::ldexp(verdict.tolerance, e);
  for (ArcFinding& arc : verdict.arcs) scale_up(arc.distance, e);
  for (CurveFinding& curve : verdict.curves) {
    scale_up(curve.distance, e);
    scale_up(curve.true_distance, e);
  }
  return verdict;
}

}  // namespace exsect
