// Products over the roots of a polynomial by resultants: for eliminants by their definition.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/resultant.h>

namespace exsect::testing {

/// lead^power f = remainder modulo p, of degree at most 1 in r, for p of degree 2 in r.
struct Reduced {
  Polynomial constant;
  Polynomial linear;
  int power;
};
inline Reduced reduced(BivariatePolynomial f, const BivariatePolynomial& p) {
  const Polynomial lead = p.coefficient(2);
  int power = 0;
  while (f.degree_r() >= 2) {
    BivariatePolynomial shift = BivariatePolynomial::constant(1);
    for (int i = f.degree_r(); i > 2; --i) shift = shift * BivariatePolynomial::r();
    const Polynomial top = f.coefficient(f.degree_r());
    f = f * lead - p * shift * top;
    ++power;
  }
  return {f.coefficient(0), f.coefficient(1), power};
}

/// prod f(s_i) over the roots of r.
inline Rational product_over_roots(const Polynomial& r, const Polynomial& f) {
  Rational lead = 1;
  for (int i = 0; i < f.degree(); ++i) lead *= r.leading_coefficient();
  return resultant(r, f) / lead;
}

}  // namespace exsect::testing
