#include "lift/torus_drawing.h"

#include <exsect/algebra/tensor_bernstein.h>

#include <algorithm>
#include <map>
#include <utility>

#include "curve/curve_place.h"
#include "curve/short_rational.h"
#include "lift/connected_parts.h"
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

/// A circle of the torus: one parameter of the patch with halves 0 is constant on it, a root of the factor.
SpaceCurve circle_on(const TorusCurve& curve, const BivariatePolynomial& factor) {
  const TorusFrame& torus = curve.frame;
  const bool is_meridian = factor.degree_s() == 0;
  SpaceCurve circle{0, SpaceCurveKind::circle, {}, false, 1};
  if (!is_meridian) circle.direction = torus.along;
  const Polynomial of = is_meridian ? factor.at_s(0) : factor.at_r(0);
  if (of.degree() != 1) return circle;
  const UnitVector from_middle = turn_by(-2 * of.coefficient(0) / of.coefficient(1) - 1);
  if (is_meridian) {
    const UnitVector a = curve.turns.around + from_middle;
    const Point outwards = a.cosine * torus.across + a.sine * torus.beside;
    circle.point = torus.centre + torus.major * outwards;
    circle.direction = cross(outwards, torus.along);
    circle.radius_squared = torus.minor * torus.minor;
  } else {
    const UnitVector b = curve.turns.across + from_middle;
    circle.point = torus.centre + torus.minor * b.sine * torus.along;
    const Rational radius = torus.major + torus.minor * b.cosine;
    circle.radius_squared = radius * radius;
  }
  if (circle.direction) circle.direction = shortened(*circle.direction);
  return circle;
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
        const bool is_circle = factor.degree_r() == 0 || factor.degree_s() == 0;
        curves.push_back(is_circle ? circle_on(curve, factor)
                                   : SpaceCurve{0, SpaceCurveKind::general, {}, false, 1});
        curves.back().id = static_cast<int>(at->second);
        curves.back().multiplicity = multiplicity;
      }
      curves[at->second].arcs.push_back(static_cast<int>(i));
    }
  }
  return curves;
}

}  // namespace exsect
