#include "special/missed_plane.h"

#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/pull_back.h>

#include "answer/finished_result.h"
#include "shape/planar_patch.h"

namespace exsect {

namespace {

/// a(s) r² + b(s) r + c(s) has no real zero over [0,1]: neither has b² - 4 a c, which is negative there.
bool has_negative_discriminant(const BivariatePolynomial& f) {
  const Polynomial c = f.coefficient(0);
  const Polynomial b = f.coefficient(1);
  const Polynomial a = f.coefficient(2);
  const Polynomial discriminant = b * b - Rational(4) * a * c;
  return !discriminant.is_zero() && discriminant(Rational(1, 2)) < 0 &&
         real_roots(discriminant, 0, 1).empty();
}

bool misses_plane_of(const BezierPatch& planar, const BezierPatch& other) {
  const auto plane = plane_of(planar);
  if (!plane) return false;
  const BivariatePolynomial height = pull_back(*plane, other);
  return has_negative_discriminant(height) || has_negative_discriminant(height.exchanged());
}

}  // namespace

std::optional<IntersectResult> intersect_missed_plane(const BezierPatch& x, const BezierPatch& y) {
  if (!misses_plane_of(x, y) && !misses_plane_of(y, x)) return std::nullopt;
  return finished({}, {}, {});
}

}  // namespace exsect
