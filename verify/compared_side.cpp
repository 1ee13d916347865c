#include "compared_side.h"

#include <cmath>

namespace exsect {
namespace {

/// Whether F has no zero in the cube p + [-r, r]^3: its terms about p, of degree k at most |c| r^k there, do
/// not reach the constant one (15.6).
bool has_no_zero_near(const ImplicitSurface& surface, const SpacePoint& p, double r) {
  if (!std::isfinite(r) || !(r >= 0)) return false;
  for (const double c : p)
    if (!std::isfinite(c)) return false;
  const Point at = {from_double(p[0]), from_double(p[1]), from_double(p[2])};
  const Rational radius = from_double(r);
  Rational constant = 0, others = 0;
  const ImplicitSurface near = surface.seen_from(at, 1);
  for (const auto& [exponents, coefficient] : near.equation().terms()) {
    Rational size = abs(coefficient);
    const int degree = exponents[0] + exponents[1] + exponents[2];
    for (int k = 0; k < degree; ++k) size *= radius;
    (degree == 0 ? constant : others) += size;
  }
  return constant > others;
}

}  // namespace

ComparedSide::ComparedSide(const ComparedSurface& surface, const Rational& margin) {
  if (const auto* patch = std::get_if<RationalPatch>(&surface))
    patch_.emplace(*patch, margin);
  else
    equation_ = std::get<ImplicitSurface>(surface);
}

bool ComparedSide::certainly_farther(const SpacePoint& p, double radius) const {
  return patch_ ? patch_->certainly_farther(p, radius) : has_no_zero_near(*equation_, p, radius);
}

}  // namespace exsect
