#include "output/drawing/revolution_curves.h"

#include <exsect/geometry/number.h>

#include <algorithm>

namespace exsect::cli {
namespace {

/// f(-r, z).
BivariatePolynomial reflected(const BivariatePolynomial& f) {
  std::vector<Polynomial> coefficients;
  for (int i = 0; i <= f.degree_r(); ++i)
    coefficients.push_back(i % 2 == 0 ? f.coefficient(i) : -f.coefficient(i));
  return BivariatePolynomial(std::move(coefficients));
}

}  // namespace

PlaneView view_of(const Rectangle& region) {
  return {{to_double(region.r.lower), to_double(region.r.upper)},
          {to_double(region.s.lower), to_double(region.s.upper)}};
}

HalfPlaneCurves half_plane_curves(const ShownRevolution& shown) {
  const PlaneView view = view_of(shown.revolution.region);
  const Revolution& revolution = shown.revolution;
  HalfPlaneCurves result;
  result.profile = drawn_curve(shown.profile);
  const double size = std::max(view.across[1] - view.across[0], view.upwards[1] - view.upwards[0]);
  const auto& bound = revolution.bounds.one_sided.distance;
  const double near = std::max(0.012 * size, bound ? 2 * to_double(*bound) : 0.03 * size);
  result.own = drawn_zero_set(revolution.profile, result.profile, near, view);
  if (shown.method != RevolutionMethod::substitution && revolution.profile.is_polynomial())
    result.mirrored =
        zero_set_in(drawn_function(PlanarFunction(reflected(revolution.profile.polynomial()))), view, 240);
  return result;
}

}  // namespace exsect::cli
