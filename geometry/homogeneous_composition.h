// Inserting homogeneous coordinates into a polynomial of two variables, over Q[t] or Q[r,s].
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <vector>

namespace exsect {

/// 1, x, ..., x^n.
template <class Ring>
std::vector<Ring> powers_up_to(const Ring& x, int n, const Ring& one) {
  std::vector<Ring> powers = {one};
  for (int i = 0; i < n; ++i) powers.push_back(powers.back() * x);
  return powers;
}

inline Polynomial ring_constant(const Polynomial&, const Rational& c) { return Polynomial(c); }
inline BivariatePolynomial ring_constant(const BivariatePolynomial&, const Rational& c) {
  return BivariatePolynomial::constant(c);
}

/// w^d f(x/w, y/w); requires d >= the total degree of f, zero for f = 0.
template <class Ring>
Ring homogeneous_composition(const BivariatePolynomial& f, const Ring& x, const Ring& y, const Ring& w,
                             int d) {
  Ring sum;
  if (f.is_zero()) return sum;
  const Ring one = ring_constant(x, 1);
  const std::vector<Ring> of_x = powers_up_to(x, f.degree_r(), one);
  const std::vector<Ring> of_y = powers_up_to(y, f.degree_s(), one);
  const std::vector<Ring> of_w = powers_up_to(w, d, one);
  for (int i = 0; i <= f.degree_r(); ++i) {
    const Polynomial row = f.coefficient(i);
    Ring inner;
    for (int j = 0; j <= row.degree(); ++j)
      if (row.coefficient(j) != 0)
        inner += ring_constant(x, row.coefficient(j)) *
                 (of_y[static_cast<std::size_t>(j)] * of_w[static_cast<std::size_t>(d - i - j)]);
    sum += of_x[static_cast<std::size_t>(i)] * inner;
  }
  return sum;
}

}  // namespace exsect
