// Values of polynomials at points given by triangular sets, as real algebraic numbers.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/algebra/triangular_point.h>

#include <optional>

namespace exsect {

/// h(p) exactly: its polynomial is irreducible, so a rational value is known to be rational.
RealAlgebraic value_at(const BivariatePolynomial& h, const TriangularPoint& p);

/// h(p) / w(p) in the same form; requires w(p) != 0. Empty where h = w = 0 in another zero of g over the same
/// s, or over one of its conjugates, so that no polynomial of the value is found.
std::optional<RealAlgebraic> quotient_at(const BivariatePolynomial& h, const BivariatePolynomial& w,
                                         const TriangularPoint& p);

/// A closed interval that contains h(p), of width at most `width` > 0.
RationalInterval enclosure_at(const BivariatePolynomial& h, const TriangularPoint& p, const Rational& width);

}  // namespace exsect
