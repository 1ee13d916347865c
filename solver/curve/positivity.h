// Proofs that polynomials are positive, by Bernstein coefficients after subdivision. Internal to solver/.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <optional>

namespace exsect {

/// Nothing if f > 0 is proved on the closed interval t; else the first part of t where it is not.
std::optional<RationalInterval> not_positive(const Polynomial& f, const RationalInterval& t);

/// The same for f(s,t), s the first variable, on [-d,d] x t; the part is one of t.
std::optional<RationalInterval> not_positive(const BivariatePolynomial& f, const Rational& d,
                                             const RationalInterval& t);

/// A positive lower bound of f on t, for a polynomial that is positive there.
Rational positive_lower_bound(const Polynomial& f, const RationalInterval& t);

}  // namespace exsect
