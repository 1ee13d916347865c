// Factors of polynomials of two variables by their multiplicities.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <vector>

namespace exsect {

struct CurveFactor {
  BivariatePolynomial factor;
  int multiplicity;
};

/// Pairwise coprime squarefree factors, not constant, of ascending multiplicities 1, 2, ..., whose product of
/// powers is f up to a rational constant. Throws std::domain_error for f = 0.
std::vector<CurveFactor> curve_factors(const BivariatePolynomial& f);

}  // namespace exsect
