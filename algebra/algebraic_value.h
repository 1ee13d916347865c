// Values of polynomials at points given by triangular sets, as real algebraic numbers.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/algebra/triangular_point.h>

namespace exsect {

/// h(p) exactly: its polynomial is irreducible, so a rational value is known to be rational.
RealAlgebraic value_at(const BivariatePolynomial& h, const TriangularPoint& p);

/// A closed interval that contains h(p), of width at most `width` > 0.
RationalInterval enclosure_at(const BivariatePolynomial& h, const TriangularPoint& p, const Rational& width);

}  // namespace exsect
