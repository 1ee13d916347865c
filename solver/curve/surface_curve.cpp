#include "curve/surface_curve.h"

#include <exsect/geometry/surface_pull_back.h>

namespace exsect {

SurfaceCurve surface_curve(const ImplicitSurface& surface, const RationalPatch& x) {
  const RationalPatch& patch = x.reduced();
  SurfaceCurve result{pull_back(surface.equation(), patch), std::nullopt, false, {}};
  if (const std::optional<HalfSpaceBound>& bound = surface.bound()) {
    SpacePolynomial form = SpacePolynomial::constant(bound->constant);
    for (std::size_t k = 0; k < 3; ++k) form += bound->normal[k] * SpacePolynomial::variable(k);
    result.half = pull_back(form, patch);
  }
  result.contains_patch = result.section.is_zero();
  if (!result.contains_patch) result.graph = curve_graph(result.section, result.half);
  return result;
}

}  // namespace exsect
