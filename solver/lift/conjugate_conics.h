// Two conics that are conjugate over a quadratic field, and what is above them in space. Internal to solver/;
// docs/method-equations.md, section 17.7.
#pragma once

#include <optional>

#include "lift/plane_conic.h"

namespace exsect {

/// The conics n = sqrt(delta) m and n = -sqrt(delta) m: the sign of n m tells points of the one from those of
/// the other. Invariant: delta > 0 is no square.
struct ConjugateConics {
  BivariatePolynomial n;
  BivariatePolynomial m;
  Rational delta;
};

/// Of an irreducible polynomial with the term s^4 and the total degree 4 (17.6a). Empty for others.
std::optional<ConjugateConics> conjugate_conics(const BivariatePolynomial& quartic);

/// The conic of space with a + b y = 0 above n = side sqrt(delta) m, side 1 or -1, in a chart as for
/// conic_in_plane; the direction of its plane where it is rational. Empty if it is in no plane, or a line.
std::optional<SpaceCurve> conic_above(const SurfaceChart& chart, const ConjugateConics& pair, int side,
                                      const SheetFunction& f);

}  // namespace exsect
