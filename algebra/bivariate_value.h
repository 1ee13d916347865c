// Values of polynomials of two variables in rings that contain Q, or enclose its numbers.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

namespace exsect {

/// f(r,s) by Horner's rule, from `ring(c)` for coefficients c and from sums and products of a ring's
/// elements; `Ring()` is zero. In a ring of enclosures the value is enclosed.
template <class Ring, class OfRational>
Ring value_in(const BivariatePolynomial& f, const Ring& r, const Ring& s, const OfRational& ring) {
  Ring sum;
  for (int i = f.degree_r(); i >= 0; --i) {
    const Polynomial coefficient = f.coefficient(i);
    Ring row;
    for (int j = coefficient.degree(); j >= 0; --j) row = row * s + ring(coefficient.coefficient(j));
    sum = sum * r + row;
  }
  return sum;
}

}  // namespace exsect
