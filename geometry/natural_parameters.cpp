#include "natural_parameters.h"

#include <exsect/algebra/polar.h>

#include <algorithm>

#include "surface_box.h"

namespace exsect {
namespace {

/// normal . (p - from) for the points p of the box.
RationalInterval range_along(const Point& normal, const Point& from,
                             const std::array<RationalInterval, 3>& box) {
  RationalInterval range = {0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational a = normal[k] * (box[k].lower - from[k]), b = normal[k] * (box[k].upper - from[k]);
    range.lower += std::min(a, b);
    range.upper += std::max(a, b);
  }
  return range;
}

/// By a number >= 0.
RationalInterval product(const RationalInterval& a, const RationalInterval& b) {
  return {a.lower * (a.lower < 0 ? b.upper : b.lower), a.upper * (a.upper < 0 ? b.lower : b.upper)};
}

RationalInterval square(const RationalInterval& a) {
  const Rational lower = a.lower * a.lower, upper = a.upper * a.upper;
  const bool has_zero = a.lower <= 0 && a.upper >= 0;
  return {has_zero ? Rational(0) : std::min(lower, upper), std::max(lower, upper)};
}

/// The part orthogonal to the axis of the coordinate axis that is the least along it, times axis . axis.
Point reference_direction(const Point& axis) {
  const Point least = least_parallel_axis(axis);
  return dot(axis, axis) * least - dot(axis, least) * axis;
}

/// Of the tube of a torus: `outwards` and `upwards` of a point are lengths of vectors times |axis|.
std::optional<RationalInterval> tube_turn(const SurfaceData& torus, const RationalInterval& off_axis,
                                          const RationalInterval& along) {
  const Rational unit = dot(torus.axis, torus.axis);
  const RationalInterval major = root_of({torus.squared * unit, torus.squared * unit});
  return turn_of({off_axis.lower - major.upper, off_axis.upper - major.lower}, along);
}

}  // namespace

NaturalParameters natural_parameters(const ImplicitSurface& surface,
                                     const std::array<RationalInterval, 3>& box) {
  const bool is_round = surface.data() && surface.kind() != SurfaceKind::plane;
  if (!is_round) return {};
  const SurfaceData& data = *surface.data();
  const Point axis =
      surface.kind() == SurfaceKind::sphere ? axis_of_box(surface).value_or(Point{0, 0, 1}) : data.axis;
  const Rational unit = dot(axis, axis);
  const Point east = reference_direction(axis);
  const RationalInterval along = range_along(axis, data.point, box);
  // (x,y) in the directions of `east` and of the axis times it, which is |axis| as long.
  const RationalInterval length = root_of({unit, unit});
  const RationalInterval x = product(range_along(east, data.point, box), length);
  const RationalInterval y = range_along(cross(axis, east), data.point, box);
  NaturalParameters result;
  result.turn = turn_of(x, y);
  if (surface.kind() != SurfaceKind::torus) {
    result.height = RationalInterval{along.lower / unit, along.upper / unit};
    return result;
  }
  const RationalInterval xx = square(x), yy = square(y);
  const Rational scale = dot(east, east);
  result.tube =
      tube_turn(data, root_of({(xx.lower + yy.lower) / scale, (xx.upper + yy.upper) / scale}), along);
  return result;
}

}  // namespace exsect
