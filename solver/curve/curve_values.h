// Where the sweep over a plane curve stops. Internal to solver/; docs/method-equations.md, section 17.1.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/real_algebraic.h>

#include <optional>
#include <vector>

namespace exsect {

/// A value of u over which the number of points, or what they are, may change.
struct CriticalValue {
  RealAlgebraic u;
  bool is_exact;            // the points over it are computed, as it may be more than the following
  bool is_vertical;         // the line is a part of the curve
  std::optional<int> side;  // f(u,side) has a simple zero; otherwise Res_v(f, f_v) has one
};

/// The closed interval of a is below that of b; the interval of a number known to be rational is that number.
bool are_apart(const RealAlgebraic& a, const RealAlgebraic& b);

/// h without its factors in common with f, also where they are multiple ones of h. Requires h != 0.
BivariatePolynomial without_factors_of(const BivariatePolynomial& f, BivariatePolynomial h);

/// A curve in one parameter alone without a real point.
bool is_nowhere_real(const BivariatePolynomial& f);

/// 0, 1, and all values between them: where f_v = 0 or the leading coefficient of f in v vanishes on f = 0, f
/// has a zero on v = 0 or v = 1 that is isolated there, one of the bounds has one on f = 0 that is isolated,
/// or `lines` has one; f is the product of the factors, by (17.1a). Ascending, each once, with disjoint
/// closed intervals. Requires squarefree factors, pairwise coprime, without one in u alone.
std::vector<CriticalValue> curve_values(const std::vector<BivariatePolynomial>& factors,
                                        const Polynomial& lines,
                                        const std::vector<BivariatePolynomial>& bounds);

}  // namespace exsect
