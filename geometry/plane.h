// Affine forms on space and the planes where they vanish.
#pragma once

#include <exsect/geometry/point.h>

#include <array>

namespace exsect {

/// An affine form on space, form(P) = normal . P + constant; the plane form = 0 unless the normal is zero.
/// Ring is Q, or Q[u] for a form that depends on the parameter u.
template <class Ring>
struct AffineFormOver {
  std::array<Ring, 3> normal;
  Ring constant;

  Ring operator()(const Point& p) const {
    return normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2] + constant;
  }
  friend bool operator==(const AffineFormOver&, const AffineFormOver&) = default;
};

using AffineForm = AffineFormOver<Rational>;

/// normal . (P - a0), the form that vanishes on the plane through a0 with this normal vector.
AffineForm form_through(const Point& a0, const Point& normal);

}  // namespace exsect
