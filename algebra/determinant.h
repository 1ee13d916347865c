// Determinants of matrices of polynomials.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <vector>

namespace exsect {

/// The determinant of a square matrix over Q[r,s], 1 for the empty one; std::invalid_argument if it is not
/// square.
BivariatePolynomial determinant(const std::vector<std::vector<BivariatePolynomial>>& matrix);

/// The positive rational multiple of f with coprime integer coefficients; zero for zero.
BivariatePolynomial primitive(const BivariatePolynomial& f);

}  // namespace exsect
