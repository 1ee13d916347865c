#include "implicitize_space_curve.h"

#include <exsect/algebra/nearest_rounding.h>

#include <stdexcept>

#include "curve/short_rational.h"
#include "gradient_norm.h"

namespace exsect {
namespace {

/// The box of the control points, a quarter of its longest side larger on every side, with short ends.
SpaceBox enlarged_box(const BezierCurve& curve, const AxisChoice& choice) {
  const int second = choice.axis == 0 ? 1 : 0, third = choice.axis == 2 ? 1 : 2;
  const PlanarBox a = enlarged_box(curve.projected(choice.axis, second));
  const PlanarBox b = enlarged_box(curve.projected(choice.axis, third));
  SpaceBox box;
  box[static_cast<std::size_t>(choice.axis)] = {std::min(a.x.lower, b.x.lower),
                                                std::max(a.x.upper, b.x.upper)};
  box[static_cast<std::size_t>(second)] = a.y;
  box[static_cast<std::size_t>(third)] = b.y;
  return box;
}

PlanarImplicit projection(const BezierCurve& curve, const SpaceOptions& options, const SpaceBox& box,
                          int axis, int other) {
  PlanarOptions planar = options.planar.value_or(PlanarOptions{});
  if (planar.space == SpaceKind::b_spline)
    throw std::invalid_argument("space curve: the projections must have polynomial equations");
  planar.box = PlanarBox{box[static_cast<std::size_t>(axis)], box[static_cast<std::size_t>(other)]};
  return implicitize(curve.projected(axis, other), planar);
}

/// In the box the surfaces meet exactly where the cylinders f = g = 0 do: (10.14) with positive norms,
/// (10.15) where f has no singular point.
bool meeting_as_cylinders(const SpaceImplicit& result, const SpaceOptions& options) {
  switch (options.method) {
    case SpaceMethod::cylinders:
      return true;
    case SpaceMethod::orthogonal:
      return result.norms_are_positive;
    case SpaceMethod::root_free:
      return result.projections[0].possibly_singular.empty();
  }
  return false;
}

}  // namespace

const char* name(SpaceMethod method) {
  switch (method) {
    case SpaceMethod::cylinders:
      return "cylinders";
    case SpaceMethod::orthogonal:
      return "orthogonal";
    case SpaceMethod::root_free:
      return "root-free";
  }
  return "";
}

SpaceImplicit implicitize_space(const BezierCurve& curve, const SpaceOptions& options) {
  return in_nearest_rounding([&] {
    const AxisChoice choice = options.axis
                                  ? AxisChoice{*options.axis, is_strictly_monotone(curve, *options.axis)}
                                  : choose_axis(curve);
    const int axis = choice.axis, second = axis == 0 ? 1 : 0, third = axis == 2 ? 1 : 2;
    const SpaceBox box = options.box.value_or(enlarged_box(curve, choice));
    const PlanarImplicit f = projection(curve, options, box, axis, second);
    const PlanarImplicit g = projection(curve, options, box, axis, third);
    ProjectedPair pair = {axis, second, third, f.function.polynomial(), g.function.polynomial()};
    SpaceImplicit result = {axis, choice.is_regular, box, {f, g}, cylinders(pair), {}, true, {}, {}};
    if (options.method == SpaceMethod::root_free) result.surfaces = orthogonal(pair);
    if (options.method == SpaceMethod::orthogonal) {
      pair.f = with_unit_gradients(pair.f, curve.projected(axis, second));
      pair.g = with_unit_gradients(pair.g, curve.projected(axis, third));
      result.norms = {fitted_gradient_norm(pair.f, f.box, options.factor_degree, options.epsilon),
                      fitted_gradient_norm(pair.g, g.box, options.factor_degree, options.epsilon)};
      result.surfaces = nearly_orthogonal(pair, (*result.norms)[0], (*result.norms)[1]);
      result.norms_are_positive =
          is_positive_on((*result.norms)[0], f.box) && is_positive_on((*result.norms)[1], g.box);
    }
    result.surfaces = {result.surfaces.first.primitive(), result.surfaces.second.primitive()};
    result.angle = largest_cosine(result.surfaces, curve);
    result.further = further_branches(
        meeting_as_cylinders(result, options) ? cylinders(pair) : result.surfaces, curve, axis, box);
    return result;
  });
}

}  // namespace exsect
