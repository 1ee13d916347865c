// Resultants and subresultants.
#pragma once

#include <vector>

#include <exsect/algebra/bivariate_polynomial.h>

namespace exsect {

/// Resultant of the Sylvester matrix of the actual degrees. res(c, g) = c^deg g for a constant c;
/// 0 if exactly one is zero and the other not constant.
Rational resultant(const Polynomial& f, const Polynomial& g);
/// Polynomial in s: the resultant with respect to r, of the actual degrees in r.
Polynomial resultant_r(const BivariatePolynomial& f, const BivariatePolynomial& g);
/// Polynomial in r: the resultant with respect to s, of the actual degrees in s.
Polynomial resultant_s(const BivariatePolynomial& f, const BivariatePolynomial& g);
/// Discriminant with respect to r: the resultant of f and f_r divided by the leading coefficient, with sign
/// (-1)^(n(n-1)/2).
Polynomial discriminant_r(const BivariatePolynomial& f);

/// Subresultant chain S_0, ..., S_{n-1}, n = min(deg f, deg g) (each of degree at most its index; S_0 is the
/// resultant), defined as determinants of submatrices of the Sylvester matrix; requires both non-constant.
std::vector<Polynomial> subresultants(const Polynomial& f, const Polynomial& g);
/// The same with respect to r.
std::vector<BivariatePolynomial> subresultants_r(const BivariatePolynomial& f, const BivariatePolynomial& g);

}  // namespace exsect
