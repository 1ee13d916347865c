// Irreducible factors of polynomials in two variables over Q.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <vector>

namespace exsect {

struct BivariatePower {
  BivariatePolynomial factor;
  int multiplicity;
};

/// Irreducible factors over Q, primitive and not constant, whose product of powers is f up to a rational
/// constant. Throws std::domain_error for f = 0.
std::vector<BivariatePower> irreducible_factors(const BivariatePolynomial& f);

}  // namespace exsect
