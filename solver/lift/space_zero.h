// Zeros of three polynomials in space, in boxes. Internal to solver/; docs/method-equations.md,
// section 17.15.
#pragma once

#include <exsect/geometry/space_polynomial.h>

#include <array>
#include <optional>

namespace exsect {

/// The closed cube of the half width `radius` about the centre. Invariant: it holds exactly one common zero
/// of three polynomials, with independent gradients.
struct SpaceZero {
  Point centre;
  double radius;
};

/// Its sides.
std::array<RationalInterval, 3> cube_of(const SpaceZero& zero);

using SpaceSystem = std::array<SpacePolynomial, 3>;

/// The one to which Newton's method goes from the guess, in a cube of the half width `radius` > 0. Empty if
/// it does not come to rest, or the proof (5.3) fails.
std::optional<SpaceZero> space_zero(const SpaceSystem& system, Point guess, double radius);

/// The sign of a polynomial on the cube, or of the determinant of the gradients; 0: not known.
int sign_on(const SpacePolynomial& f, const SpaceZero& zero);
int orientation_on(const SpaceSystem& system, const SpaceZero& zero);

}  // namespace exsect
