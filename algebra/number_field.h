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

/// At least the degree in r of gcd_modulo(f, h, g), for an irreducible g: the degree of the greatest common
/// divisor of the images of f and h modulo a prime and at a root of g modulo it. Almost always equal, and
/// found in a small part of the time. Empty if f = h = 0, or no prime that will do is among the first that
/// are tried. Throws std::domain_error for a constant g.
std::optional<int> gcd_degree_bound(const BivariatePolynomial& f, const BivariatePolynomial& h,
                                    const Polynomial& g);

}  // namespace exsect
