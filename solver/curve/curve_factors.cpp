#include "curve/curve_factors.h"

#include "curve/plane_curve.h"

namespace exsect {

std::vector<CurveFactor> curve_factors(const BivariatePolynomial& f) {
  // Invariant: rest = product of (factor of multiplicity m)^(m - k), m > k, and squarefree(rest) is
  // `radical`.
  std::vector<CurveFactor> result;
  BivariatePolynomial radical = squarefree(f), rest = exact_quotient(f, radical);
  for (int k = 1; radical.degree_r() > 0 || radical.degree_s() > 0; ++k) {
    const BivariatePolynomial further = gcd(radical, rest);
    const BivariatePolynomial factor = exact_quotient(radical, further);
    if (factor.degree_r() > 0 || factor.degree_s() > 0) result.push_back({factor, k});
    radical = further;
    rest = exact_quotient(rest, further);
  }
  return result;
}

}  // namespace exsect
