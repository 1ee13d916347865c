#include "line/surface_ray.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/surface_pull_back.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace exsect {
namespace {

/// Greater than every real root (Cauchy).
Rational above_all_roots(const Polynomial& f) {
  Rational greatest = 0;
  for (const Rational& c : f.coefficients()) greatest = std::max<Rational>(greatest, abs(c));
  return 1 + greatest / abs(f.leading_coefficient());
}

/// The region of a surface along a ray.
class RayRegion {
 public:
  RayRegion(const SurfaceRegion& region, const Point& origin, const Point& direction)
      : clauses_(region.clauses) {
    for (const SurfaceBound& bound : region.bounds)
      bounds_.push_back(pull_back(bound.form, origin, direction));
  }

  bool contains(const RealAlgebraic& t) const {
    return std::ranges::all_of(clauses_, [&](const std::vector<std::size_t>& clause) {
      return std::ranges::any_of(clause, [&](std::size_t i) { return sign_at(bounds_[i], t) >= 0; });
    });
  }

  /// All of t >= 0 in it: closed pieces, ascending, which have no point in common.
  std::vector<RayOverlap> pieces() const {
    const std::vector<RealAlgebraic> breaks = breaks_of_ray();
    std::vector<RayOverlap> result;
    bool goes_on = false;
    for (std::size_t i = 0; i < breaks.size(); ++i) {
      if (goes_on)
        result.back().to = breaks[i];
      else if (contains(breaks[i]))
        result.push_back({breaks[i], breaks[i]});
      const Rational end = breaks[i].interval().upper;
      const Rational behind =
          i + 1 < breaks.size() ? simplest_between(end, breaks[i + 1].interval().lower) : Rational(end + 1);
      goes_on = contains(RealAlgebraic(behind));
      if (goes_on) result.back().to.reset();
    }
    return result;
  }

 private:
  /// 0 and the zeros of the bounds above it, with disjoint closed intervals.
  std::vector<RealAlgebraic> breaks_of_ray() const {
    std::vector<RealAlgebraic> breaks = {0};
    for (const Polynomial& bound : bounds_)
      if (bound.degree() > 0) {
        const std::vector<RealAlgebraic> zeros = real_roots(bound, 0, above_all_roots(bound));
        breaks.insert(breaks.end(), zeros.begin(), zeros.end());
      }
    std::ranges::sort(breaks, [](const RealAlgebraic& a, const RealAlgebraic& b) { return a < b; });
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
      for (Rational width = power_of_two(-20); breaks[i].interval().upper >= breaks[i + 1].interval().lower;
           width *= width) {
        breaks[i] = breaks[i].refined_to(width);
        breaks[i + 1] = breaks[i + 1].refined_to(width);
      }
    return breaks;
  }

  std::vector<Polynomial> bounds_;
  std::vector<std::vector<std::size_t>> clauses_;
};

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
    const Polynomial f = on_ray(surface.equation());
    const RayRegion region(surface.region(), origin, direction);
    RayIntersection result;
    if (f.is_zero()) {
      result.overlaps = region.pieces();
      return result;
    }
    if (f.degree() == 0) return result;
    std::array<Polynomial, 3> gradient;
    for (std::size_t k = 0; k < 3; ++k) gradient[k] = on_ray(surface.equation().derivative(k));
    for (const PolynomialPower& power : squarefree_factors(f))
      for (const RealAlgebraic& t : real_roots(power.factor, 0, above_all_roots(f))) {
        if (!region.contains(t)) continue;
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
