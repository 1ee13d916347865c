#include "line/surface_ray.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/surface_pull_back.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace exsect {
namespace {

/// The value of the bound along the ray; 1 for a surface without one.
Polynomial bound_on_ray(const Point& origin, const Point& direction, const ImplicitSurface& surface) {
  const std::optional<HalfSpaceBound>& bound = surface.bound();
  return bound ? Polynomial{(*bound)(origin), dot(bound->normal, direction)} : Polynomial(1);
}

/// Greater than every real root (Cauchy).
Rational above_all_roots(const Polynomial& f) {
  Rational greatest = 0;
  for (const Rational& c : f.coefficients()) greatest = std::max<Rational>(greatest, abs(c));
  return 1 + greatest / abs(f.leading_coefficient());
}

/// Where a linear or constant polynomial is not negative, t >= 0.
std::optional<RayOverlap> where_not_negative(const Polynomial& linear) {
  const Rational at_origin = linear.coefficient(0), rate = linear.coefficient(1);
  if (rate == 0) return at_origin < 0 ? std::nullopt : std::optional(RayOverlap{0, std::nullopt});
  const Rational zero = -at_origin / rate;
  if (rate > 0) return RayOverlap{std::max<Rational>(zero, 0), std::nullopt};
  return zero < 0 ? std::nullopt : std::optional(RayOverlap{0, RealAlgebraic(zero)});
}

}  // namespace

const char* name(RayContact contact) {
  switch (contact) {
    case RayContact::transversal:
      return "transversal";
    case RayContact::tangential:
      return "tangential";
    default:
      return "singular";
  }
}

RayIntersection intersect_ray(const Point& origin, const Point& direction, const ImplicitSurface& surface) {
  if (is_zero(direction)) throw std::invalid_argument("intersect_ray: the direction is zero");
  return in_nearest_rounding([&] {
    const auto on_ray = [&](const SpacePolynomial& f) { return pull_back(f, origin, direction); };
    const Polynomial bound = bound_on_ray(origin, direction, surface), f = on_ray(surface.equation());
    RayIntersection result;
    if (f.is_zero()) {
      if (const std::optional<RayOverlap> overlap = where_not_negative(bound)) result.overlaps = {*overlap};
      return result;
    }
    if (f.degree() == 0) return result;
    std::array<Polynomial, 3> gradient;
    for (std::size_t k = 0; k < 3; ++k) gradient[k] = on_ray(surface.equation().derivative(k));
    for (const PolynomialPower& power : squarefree_factors(f))
      for (const RealAlgebraic& t : real_roots(power.factor, 0, above_all_roots(f))) {
        if (sign_at(bound, t) < 0) continue;
        const bool singular = std::all_of(gradient.begin(), gradient.end(),
                                          [&](const Polynomial& g) { return sign_at(g, t) == 0; });
        result.hits.push_back({t, power.multiplicity,
                               singular                 ? RayContact::singular
                               : power.multiplicity > 1 ? RayContact::tangential
                                                        : RayContact::transversal});
      }
    std::sort(result.hits.begin(), result.hits.end(),
              [](const RayHit& a, const RayHit& b) { return a.t < b.t; });
    return result;
  });
}

}  // namespace exsect
