// Quotients of quadratic polynomials that map [0,1] onto itself: what the pencils of planes of circles tell
// of their parameters. Internal to solver/; docs/method-equations.md, section 17.19.
#pragma once

#include <exsect/algebra/polynomial.h>

#include "special/space_form.h"

namespace exsect {

/// w = b / (a + b) with a = (1 - p)(1 + start p) and b = p (1 + end (1 - p)) (17.24): strictly increasing
/// from 0 to 1 on [0,1] for start, end >= -1; w = p if both are 0.
struct UnitMap {
  Rational start = 0;
  Rational end = 0;

  bool is_identity() const { return start == 0 && end == 0; }
};

/// Where the values of w are in the interval, of [0,1], in an interval that is wider by at most 2^-bits to
/// both sides.
RationalInterval preimage(const UnitMap& map, const RationalInterval& values, int bits);

/// About where w has a value from [0,1].
double approximate_preimage(const UnitMap& map, double value);

/// The other parameter with the same w is (k0 + k1 p) / (k2 + k3 p), and p again that of it.
using Conjugation = std::array<Rational, 4>;
Conjugation conjugation(const UnitMap& map);

/// y with this in the place of the first parameter, times a power of the denominator.
VectorPolynomial at_conjugate(const Conjugation& other, const VectorPolynomial& y);

}  // namespace exsect
