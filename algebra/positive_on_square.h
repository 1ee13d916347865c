// Positivity of a polynomial in two variables on the closed unit square, decided exactly.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <optional>

namespace exsect {

/// A point of the closed unit square in intervals of length at most 2^-60; one whose ends agree is the
/// coordinate itself. `sign` is that of the polynomial at the point: 0 or -1.
struct NotPositive {
  RationalInterval r;
  RationalInterval s;
  int sign;
};

/// Lemma 16.1: nothing if f > 0 on [0,1]^2, else where it is not: the corner (0,0) if f <= 0 there, otherwise
/// a zero of f. Subdivision decides unless f has a zero and no negative value near by; then the zeros are
/// found: on the four sides by real roots, inside by the extreme points of the curve, which are zeros of the
/// squarefree part and of its derivative in s.
std::optional<NotPositive> not_positive_on_square(const BivariatePolynomial& f);

}  // namespace exsect
