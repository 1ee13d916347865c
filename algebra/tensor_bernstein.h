// The tensor product Bernstein basis on rectangles: exact bounds of polynomials in two variables.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <vector>

namespace exsect {

/// A closed rectangle of (r,s).
struct Rectangle {
  RationalInterval r = {0, 1};
  RationalInterval s = {0, 1};
};

/// The coefficients b[i][j] of f on the rectangle in the products of the Bernstein polynomials of degree m in
/// r and n in s; f lies between the least and the greatest of them there. Throws std::invalid_argument unless
/// m >= deg_r f, n >= deg_s f, m, n >= 0, and both sides have positive length.
std::vector<std::vector<Rational>> tensor_bernstein(const BivariatePolynomial& f, int m, int n,
                                                    const Rectangle& on = {});

/// An interval that contains all values of f on the rectangle, from the Bernstein coefficients on 2^depth by
/// 2^depth equal parts. Throws std::invalid_argument unless 0 <= depth <= 10 and both sides have positive
/// length.
RationalInterval range_bound(const BivariatePolynomial& f, const Rectangle& on = {}, int depth = 0);

}  // namespace exsect
