// Greatest common divisors of polynomials in three variables.
#pragma once

#include <exsect/algebra/polynomial.h>

#include <vector>

namespace exsect {

/// An element of Q[u][r,s]: coefficients[i][j], a polynomial in u, multiplies r^i s^j. Rows of any lengths,
/// zeros allowed; no coefficients: zero.
using TrivariateCoefficients = std::vector<std::vector<Polynomial>>;

/// The monic greatest common divisor in Q[u,r,s] (lexicographic order r, s, u); gcd(0,0) = 0.
TrivariateCoefficients gcd(const TrivariateCoefficients& a, const TrivariateCoefficients& b);

}  // namespace exsect
