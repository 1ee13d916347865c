// The points of a curve that is known by factors, over one value of u. Internal to solver/;
// docs/method-equations.md, section 17.1.
#pragma once

#include <exsect/algebra/triangular_point.h>

#include <cstddef>
#include <vector>

namespace exsect {

/// A zero v over a rational u, and which factor has it.
struct FactorRoot {
  RealAlgebraic v;
  std::size_t factor;
};
/// A point over an algebraic u, and the factors that have it.
struct FactorPoint {
  TriangularPoint at;
  std::vector<std::size_t> factors;
};

/// Squarefree factors, each two of them coprime, that have the same zeros together; constants give none, and
/// the parts that two have in common stay with the first. Throws std::domain_error for a zero polynomial.
std::vector<BivariatePolynomial> coprime_factors(const std::vector<BivariatePolynomial>& polynomials);

/// In [0,1], ascending in v. Requires that no two factors have a zero in common over u, and that none is 0
/// there.
std::vector<FactorRoot> roots_over(const std::vector<BivariatePolynomial>& factors, const Rational& u);
/// In [0,1], ascending in v, each once, with disjoint intervals. Factors have v in the place of r; none is 0
/// over u, else std::domain_error.
std::vector<FactorPoint> points_over(const std::vector<BivariatePolynomial>& factors, const RealAlgebraic& u);

/// v is no zero of a factor while u is in the closed interval; false may be wrong.
bool has_no_zero_along(const std::vector<BivariatePolynomial>& factors, const Rational& v,
                       const RationalInterval& u);

}  // namespace exsect
