// Resultants and subresultants.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <vector>

namespace exsect {

/// Resultant of the Sylvester matrix of the actual degrees. res(c, g) = c^deg g for a nonzero constant c; 0
/// if f or g is zero.
Rational resultant(const Polynomial& f, const Polynomial& g);
/// Polynomial in s: the resultant with respect to r, of the actual degrees in r.
Polynomial resultant_r(const BivariatePolynomial& f, const BivariatePolynomial& g);
/// Polynomial in r: the resultant with respect to s, of the actual degrees in s.
Polynomial resultant_s(const BivariatePolynomial& f, const BivariatePolynomial& g);
/// Discriminant with respect to r: the resultant of f and f_r divided by the leading coefficient, with sign
/// (-1)^(n(n-1)/2). Requires degree n >= 1 in r, else std::domain_error.
Polynomial discriminant_r(const BivariatePolynomial& f);

/// Subresultant chain S_0, ..., S_{n-1}, n = min(deg f, deg g) (each of degree at most its index; S_0 is the
/// resultant), defined as determinants of submatrices of the Sylvester matrix; requires both non-constant,
/// else std::domain_error.
std::vector<Polynomial> subresultants(const Polynomial& f, const Polynomial& g);
/// The same with respect to r.
std::vector<BivariatePolynomial> subresultants_r(const BivariatePolynomial& f, const BivariatePolynomial& g);
/// The coefficient of r^k in S_j with respect to r alone; requires 0 <= k <= j < min(deg f, deg g), else
/// std::domain_error.
Polynomial subresultant_coefficient_r(const BivariatePolynomial& f, const BivariatePolynomial& g, int j,
                                      int k);

}  // namespace exsect
