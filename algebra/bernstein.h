// The Bernstein basis on [0,1] and de Casteljau subdivision, exact.
#pragma once

#include <exsect/algebra/polynomial.h>

#include <vector>

namespace exsect {

/// Binomial coefficient, 0 outside 0 <= k <= n.
Integer binomial(int n, int k);

/// Bernstein coefficients b_i of f on [a,b] for degree n: f(a + t(b-a)) = sum b_i binom(n,i) t^i (1-t)^(n-i).
/// Requires n >= deg f and a < b, else std::invalid_argument.
std::vector<Rational> bernstein_coefficients(const Polynomial& f, int n, const Rational& a = 0,
                                             const Rational& b = 1);
/// The polynomial with the given Bernstein coefficients on [0,1].
Polynomial from_bernstein(const std::vector<Rational>& coefficients);

struct BernsteinHalves {
  std::vector<Rational> left;
  std::vector<Rational> right;
};
/// The Bernstein coefficients on [0,t] and [t,1] (de Casteljau).
BernsteinHalves split_bernstein(const std::vector<Rational>& coefficients, const Rational& t);

/// Sign changes in the list, zeros skipped: Descartes' bound for the roots in the open interval (0,1), exact
/// when it is 0 or 1, of the same parity as the number of roots counted with multiplicity.
int sign_variations(const std::vector<Rational>& coefficients);

}  // namespace exsect
