#include "lift/torus_drawing.h"

#include <exsect/algebra/tensor_bernstein.h>

#include <algorithm>
#include <map>
#include <utility>

#include "curve/curve_place.h"
#include "curve/short_rational.h"
#include "lift/connected_parts.h"
#include "lift/plane_conic.h"
#include "lift/surface_chart.h"

namespace exsect {
namespace {

/// Rectangles have sides of positive length.
const Rational& least_width() {
  static const Rational width = power_of_two(-200);
  return width;
}
RationalInterval with_room(const RationalInterval& a) {
  return {a.lower - least_width(), a.upper + least_width()};
}

/// Above an irreducible factor of degree 1 in both parameters at most: the circle of the plane and the sphere
/// that contain it, if there are any.
std::optional<SpaceCurve> circle_above(const RationalPatch& patch, const BivariatePolynomial& factor) {
  if (factor.degree_r() > 1 || factor.degree_s() > 1) return std::nullopt;
  const BivariatePolynomial w = patch.component(3);
  std::vector<std::vector<BivariatePolynomial>> columns = {{w * w}};
  BivariatePolynomial squares;
  for (int k = 0; k < 3; ++k) {
    columns.push_back({patch.component(k) * w});
    squares += patch.component(k) * patch.component(k);
  }
  columns.push_back({squares});
  const std::vector<std::vector<Integer>> relations = relations_on(columns, factor);
  if (relations.size() != 2) return std::nullopt;
  // d + n.P + e |P|^2 = 0: a sphere, and a plane from both.
  const bool is_sphere = relations[0][4] != 0;
  const std::vector<Integer>&sphere = relations[is_sphere ? 0 : 1], &other = relations[is_sphere ? 1 : 0];
  const Rational e(sphere[4]), share = Rational(other[4]) / e;
  std::array<Rational, 4> plane;
  for (std::size_t k = 0; k < 4; ++k) plane[k] = Rational(other[k]) - share * Rational(sphere[k]);
  const Point normal = {plane[1], plane[2], plane[3]},
              middle = -1 / (2 * e) * Point{Rational(sphere[1]), Rational(sphere[2]), Rational(sphere[3])};
  const Point off = (plane[0] + dot(normal, middle)) / dot(normal, normal) * normal;
  SpaceCurve circle{0, SpaceCurveKind::circle, {}, false, 1};
  circle.point = middle - off;
  circle.direction = shortened(normal);
  circle.radius_squared = dot(middle, middle) - Rational(sphere[0]) / e - dot(off, off);
  return circle;
}

/// One parameter of the patch with halves 0 is constant on a circle in a plane through the axis, or
/// orthogonal to it.
SpaceCurve named_above(const TorusCurve& curve, const BivariatePolynomial& factor) {
  if (auto circle = circle_above(curve.parts[0].patch, factor)) return *std::move(circle);
  const bool is_circle = factor.degree_r() == 0 || factor.degree_s() == 0;
  SpaceCurve named{0, is_circle ? SpaceCurveKind::circle : SpaceCurveKind::general, {}, false, 1};
  if (factor.degree_r() == 0) named.direction = shortened(curve.frame.along);
  return named;
}

}  // namespace

TorusDrawing::TorusDrawing(const TorusCurve& curve, double tolerance) : curve_(curve), tolerance_(tolerance) {
  for (const TorusPart& part : curve.parts) {
    Part drawn{DrawnPatch(part.patch), {}};
    const Rational width = std::min<Rational>(power_of_two(-80), place_width(drawn.patch, tolerance));
    for (std::size_t i = 0; i < part.curve.graph.nodes.size(); ++i)
      drawn.places.push_back(place_of(part.curve.graph, i, width));
    parts_.push_back(std::move(drawn));
  }
}

SpaceBox TorusDrawing::box(std::size_t node) const {
  const TorusNode& at = curve_.nodes[node];
  const RationalPatch& patch = curve_.parts[at.part].patch;
  const NodePlace& place = parts_[at.part].places[at.below];
  const Rectangle on{with_room(place[0]), with_room(place[1])};
  const RationalInterval weight = range_bound(patch.component(3), on);
  SpaceBox box;
  for (std::size_t k = 0; k < 3; ++k)
    box[k] = quotients(range_bound(patch.component(static_cast<int>(k)), on), weight);
  return box;
}

SpaceCourse TorusDrawing::course(std::size_t arc) const {
  const TorusArc& at = curve_.arcs[arc];
  const Part& part = parts_[at.part];
  CurveCourse course =
      curve_course(curve_.parts[at.part].curve.graph, part.places, at.below, part.patch, tolerance_);
  return {std::move(course.points), course.error_bound};
}

double extent_of(const TorusFrame& torus) { return 2 * to_double(torus.major + torus.minor); }

std::vector<SpaceCurve> named_curves(const TorusCurve& curve) {
  std::vector<SpaceCurve> curves;
  for (std::size_t k = 0; k < curve.factors.size(); ++k) {
    const auto& [factor, multiplicity] = curve.factors[k];
    const ConnectedParts parts(curve, k);
    std::map<int, std::size_t> position;
    for (std::size_t i = 0; i < curve.arcs.size(); ++i) {
      if (curve.arcs[i].factor != k) continue;
      const auto [at, is_new] = position.emplace(parts(curve.arcs[i]), curves.size());
      if (is_new) {
        curves.push_back(named_above(curve, factor));
        curves.back().id = static_cast<int>(at->second);
        curves.back().multiplicity = multiplicity;
      }
      curves[at->second].arcs.push_back(static_cast<int>(i));
    }
  }
  return curves;
}

}  // namespace exsect
