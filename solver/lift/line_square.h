// Quadratic polynomials in two variables that are squares of lines. Internal to solver/;
// docs/method-equations.md, section 17.7.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <array>
#include <vector>

namespace exsect {

/// m_00 u^2 + 2 m_01 u v + m_11 v^2 + 2 m_02 u + 2 m_12 v + m_22, with polynomials in one parameter.
using SymmetricMatrix = std::array<std::array<Polynomial, 3>, 3>;

/// Of f + t g with the parameter t, both of degree at most 2.
SymmetricMatrix symmetric_matrix(const BivariatePolynomial& f, const BivariatePolynomial& g);

/// For the parameter `at` the quadratic polynomial is line^2 / factor, factor != 0.
struct LineSquare {
  Rational at;
  BivariatePolynomial line;
  Rational factor;
};

/// For all rational parameters for which it is one: those for which the matrix has the rank 1, so common
/// roots of its minors. None if there are such for all parameters.
std::vector<LineSquare> line_squares(const SymmetricMatrix& m);

}  // namespace exsect
