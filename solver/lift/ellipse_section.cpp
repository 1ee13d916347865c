#include "lift/ellipse_section.h"

#include <exsect/algebra/polar.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "lift/exact_chart.h"
#include "lift/surface_chart.h"

namespace exsect {
namespace {

/// normal . P = height.
struct CuttingPlane {
  Point normal;
  Rational height;
};

bool is_cut(SurfaceKind kind) {
  return kind == SurfaceKind::sphere || kind == SurfaceKind::cylinder || kind == SurfaceKind::cone;
}

/// (17.21): of |a|^2 |q|^2 - slant (a.q)^2 - constant on the plane.
std::optional<EllipseSection> section(const ImplicitSurface& quadric, const CuttingPlane& plane) {
  const SurfaceData& data = *quadric.data();
  const bool is_sphere = quadric.kind() == SurfaceKind::sphere;
  const Point axis = is_sphere ? plane.normal : data.axis;
  const Rational unit = is_sphere ? Rational(1) : dot(axis, axis);
  const Rational slant = is_sphere                             ? Rational(0)
                         : quadric.kind() == SurfaceKind::cone ? Rational(1 + data.squared)
                                                               : Rational(1);
  const Rational constant = quadric.kind() == SurfaceKind::cone ? Rational(0) : Rational(data.squared * unit);
  Point across = cross(axis, plane.normal);
  if (is_zero(across)) across = cross(axis, least_parallel_axis(axis));
  const Point along = cross(plane.normal, across);
  const Rational nn = dot(plane.normal, plane.normal);
  const Rational off = (plane.height - dot(plane.normal, data.point)) / nn;
  const Rational up = dot(axis, along), out = off * dot(axis, plane.normal);
  const Rational a = unit * dot(along, along) - slant * up * up, b = -slant * out * up,
                 c = unit * off * off * nn - slant * out * out - constant, d = unit * dot(across, across);
  if (a <= 0) return std::nullopt;
  const Rational centre = -b / a, reach = b * b / a - c;
  if (reach <= 0) return std::nullopt;
  return EllipseSection{data.point + off * plane.normal + centre * along, along, across, reach / a,
                        reach / d};
}

/// Of the points that two spheres have in common.
CuttingPlane radical_plane(const SurfaceData& first, const SurfaceData& second) {
  return {Rational(2) * (second.point - first.point),
          dot(second.point, second.point) - dot(first.point, first.point) - second.squared + first.squared};
}

SpaceCurve name_of(const EllipseSection& ellipse) {
  SpaceCurve curve{0,
                   SpaceCurveKind::ellipse,
                   {0, 1},
                   true,
                   1,
                   ellipse.centre,
                   shortened(cross(ellipse.along, ellipse.across))};
  const Rational squared = ellipse.along_reach * dot(ellipse.along, ellipse.along);
  if (squared == ellipse.across_reach * dot(ellipse.across, ellipse.across)) {
    curve.kind = SpaceCurveKind::circle;
    curve.radius_squared = squared;
  }
  return curve;
}

/// About cosines and sines of angles that grow from 0 to half a turn, and how far from the unit circle, and
/// its arcs from the chords between the next points on it, they are at most.
struct CircleChords {
  std::vector<std::array<double, 2>> points;
  double off;
  double sagitta;
};

/// The points are what is checked, however they were computed.
CircleChords circle_chords(std::size_t quarter) {
  CircleChords half;
  const std::size_t n = 2 * quarter;
  half.points.resize(n + 1);
  for (std::size_t k = 0; k <= quarter; ++k) {
    const double angle = std::numbers::pi / 2 * static_cast<double>(k) / static_cast<double>(quarter);
    const double c = k == quarter ? 0 : std::cos(angle), s = k == 0 ? 0 : std::sin(angle);
    half.points[k] = {c, s};
    half.points[n - k] = {-c, s};
  }
  double off = 0, widest = 0;
  bool ascends = true;
  for (std::size_t k = 0; k < quarter; ++k) {
    const auto [c, s] = half.points[k];
    const auto [d, t] = half.points[k + 1];
    off = larger_bound(off, std::fabs(c * c + s * s - 1));
    ascends = ascends && c > 0 && s >= 0 && t > 0 && d >= 0 && c * t - s * d > 0x1p-50;
    widest = larger_bound(widest, (c - d) * (c - d) + (s - t) * (s - t));
  }
  if (!ascends || !(off < 0x1p-40) || !(widest < 0.25))
    throw ProofFailure(whole_domain(), "points of a circle are not in order");
  half.off = off + 0x1p-50;
  const double chord = (std::sqrt(widest) + 2 * half.off) * kSlack, squared = chord * chord;
  half.sagitta = (squared / 8 + squared * squared / 32) * kSlack;  // (17.22)
  return half;
}

/// The semi-axis in a direction, with sqrt(reach) enclosed.
struct SemiAxis {
  SpaceBox box;
  std::array<double, 3> vector;
  double length;  // not below its length
};

SemiAxis semi_axis(const Point& direction, const Rational& reach) {
  const RationalInterval root = root_of({reach, reach});
  SemiAxis axis{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational a = direction[k] * root.lower, b = direction[k] * root.upper;
    axis.box[k] = {std::min(a, b), std::max(a, b)};
    axis.vector[k] = to_double(axis.box[k].midpoint());
  }
  axis.length = length_bound(axis.vector[0], axis.vector[1], axis.vector[2]) * kSlack + kUnderflowLoss;
  return axis;
}

SpaceBox moved(const Point& centre, const SpaceBox& by, bool is_back) {
  SpaceBox box;
  for (std::size_t k = 0; k < 3; ++k)
    box[k] = is_back ? RationalInterval{centre[k] - by[k].upper, centre[k] - by[k].lower}
                     : RationalInterval{centre[k] + by[k].lower, centre[k] + by[k].upper};
  return box;
}

SpaceNode ellipse_end(int id, SpaceBox box) {
  std::array<double, 3> approx{};
  for (std::size_t k = 0; k < 3; ++k) approx[k] = to_double(box[k].midpoint());
  return {id, SpaceNodeKind::joint, 2, std::move(box), approx};
}

}  // namespace

std::optional<EllipseSection> ellipse_section(const ImplicitSurface& first, const ImplicitSurface& second) {
  const SurfaceKind kind = first.kind();
  if (kind == SurfaceKind::plane && is_cut(second.kind())) return ellipse_section(second, first);
  if (is_cut(kind) && second.kind() == SurfaceKind::plane) {
    const SurfaceData& plane = *second.data();
    return section(first, {plane.axis, dot(plane.axis, plane.point)});
  }
  if (kind != SurfaceKind::sphere || second.kind() != SurfaceKind::sphere) return std::nullopt;
  const CuttingPlane plane = radical_plane(*first.data(), *second.data());
  return is_zero(plane.normal) ? std::nullopt : section(first, plane);
}

SurfaceIntersection drawn(const EllipseSection& ellipse, const std::function<double(double)>& tolerance) {
  const SemiAxis along = semi_axis(ellipse.along, ellipse.along_reach),
                 across = semi_axis(ellipse.across, ellipse.across_reach);
  const double longest = larger_bound(along.length, across.length), wanted = tolerance(2 * longest);
  const double steps = std::ceil(std::numbers::pi / 2 * std::sqrt(longest / (8 * wanted)) * (1 + 0x1p-20));
  const CircleChords half = circle_chords(static_cast<std::size_t>(larger_bound(steps, 4)) + 1);
  SurfaceIntersection result{Status::complete};
  result.nodes = {ellipse_end(0, moved(ellipse.centre, along.box, true)),
                  ellipse_end(1, moved(ellipse.centre, along.box, false))};
  std::array<double, 3> centre{};
  double rounding = kUnderflowLoss;  // of three terms, each rounded, and their sums, in all coordinates
  for (std::size_t k = 0; k < 3; ++k) {
    centre[k] = to_double(ellipse.centre[k]);
    rounding += (std::fabs(centre[k]) + std::fabs(along.vector[k]) + std::fabs(across.vector[k])) * 0x1p-50;
  }
  // Vertices are next to points of the ellipse, and these are ends of chords.
  const double error = (longest * (half.sagitta + half.off) + rounding) * kSlack;
  for (const int side : {1, -1}) {
    std::vector<std::array<double, 3>> polyline(half.points.size());
    for (std::size_t i = 0; i < polyline.size(); ++i) {
      const double x = -half.points[i][0], y = side * half.points[i][1];
      for (std::size_t k = 0; k < 3; ++k)
        polyline[i][k] = centre[k] + (x * along.vector[k] + y * across.vector[k]);
    }
    polyline.front() = result.nodes[0].approx;
    polyline.back() = result.nodes[1].approx;
    result.arcs.push_back({side > 0 ? 0 : 1, 0, 0, 1, 1, std::move(polyline), error});
  }
  result.curves.push_back(name_of(ellipse));
  return result;
}

std::optional<SurfaceIntersection> ellipse_intersection(const ImplicitSurface& first,
                                                        const ImplicitSurface& second,
                                                        const PairRegion& region,
                                                        const std::function<double(double)>& tolerance) {
  const std::size_t nappes = (first.bound() ? 1U : 0U) + (second.bound() ? 1U : 0U);
  if (region.all.clauses.size() > nappes) return std::nullopt;
  const std::optional<EllipseSection> ellipse = ellipse_section(first, second);
  if (!ellipse) return std::nullopt;
  // An ellipse is around the axis of its cone, on one side of the apex, and so is its centre.
  if (!region.all.contains(ellipse->centre)) return SurfaceIntersection{Status::complete};
  SurfaceIntersection result = drawn(*ellipse, tolerance);
  // In the middle of the arc n1 x along points along the plane's normal, or against it, for a quadric n1.
  const bool is_quadric_first = second.kind() == SurfaceKind::plane;
  for (SpaceArc& arc : result.arcs) {
    const int left = (arc.id == 0) == is_quadric_first ? 1 : -1;
    arc.beside = SideSigns{left, -left};
  }
  return result;
}

}  // namespace exsect
