// Arithmetic in a number field Q[s]/(g), g irreducible, by polynomials in s.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <optional>

namespace exsect {

/// The polynomial b of degree below that of g with a b = 1 modulo g; empty if a and g have a common factor.
/// Throws std::domain_error for a constant g.
std::optional<Polynomial> inverse_modulo(const Polynomial& a, const Polynomial& g);

/// The greatest common divisor in r of f(r,s) and h(r,s) over the field Q[s]/(g), with leading coefficient 1
/// and coefficients reduced modulo g; zero if both are. Empty if an element other than 0 turns out to have no
/// inverse: g is not irreducible.
std::optional<BivariatePolynomial> gcd_modulo(const BivariatePolynomial& f, const BivariatePolynomial& h,
                                              const Polynomial& g);

}  // namespace exsect
