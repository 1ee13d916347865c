// Exact sign of alpha + beta sqrt(D).
#pragma once

#include <exsect/algebra/polynomial.h>
#include <exsect/algebra/real_algebraic.h>

namespace exsect {

/// -1, 0, +1 from the signs of alpha, beta and alpha^2 - beta^2 D (2.4); requires D >= 0, else
/// std::domain_error.
int quadratic_sign(const Rational& alpha, const Rational& beta, const Rational& d);

/// The same with alpha, beta, D polynomials at a real algebraic number s.
int quadratic_sign(const Polynomial& alpha, const Polynomial& beta, const Polynomial& d,
                   const RealAlgebraic& s);

}  // namespace exsect
