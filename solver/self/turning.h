// The values of a parameter over which the curve of self-intersection may turn, or be singular. Internal to
// solver/; docs/method.md, section 7.6.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <optional>
#include <vector>

namespace exsect {

/// The pairs x(u1,v1) = x(u2,v2) over their (u2,v1), r = u2 and s = v1: with d = u1 - u2 and e = v2 - v1,
///   b d + a d^2 - x_v e - x_vv/2 e^2 = 0,  b = x_u, a = x_uu/2 at (u2,v1)                          (7.12)
/// so that d : d^2 : e : e^2 are the 3 x 3 minors of this system. Factors of all of them that vanish on a
/// side u = 0, 1 that is one point are left out.
struct SelfProjection {
  std::array<BivariatePolynomial, 4> minors;  // proportional to d, d^2, e, e^2
  BivariatePolynomial curve;                  // Q (7.1): zero at all pairs off such sides
};
SelfProjection self_projection(const BezierPatch& x);

/// Values of v1 in [0,1], ascending, each once, with irreducible polynomials. Over an open interval without
/// them the pairs in the square, off sides that are one point, are disjoint arcs, analytic graphs over v1, at
/// most one over each (u2,v1), and no line v1 = constant holds infinitely many. Empty if this cannot be had:
/// Q vanishes, or has a multiple factor on which all minors do.
std::optional<std::vector<RealAlgebraic>> self_turning_values(const BezierPatch& x);

/// The values of v of all cuspidal points, x_u x x_v = 0, off sides u = 0, 1 that are cuspidal in whole, and
/// possibly others; empty if these are not isolated over the complex numbers.
std::optional<std::vector<RealAlgebraic>> cuspidal_values(const BezierPatch& x);

/// Both of them for u (index 0) and for v (1), empty if they are not known.
struct SelfValues {
  std::array<std::optional<std::vector<RealAlgebraic>>, 2> turning;
  std::array<std::optional<std::vector<RealAlgebraic>>, 2> cuspidal;
};
SelfValues self_values(const BezierPatch& x);

}  // namespace exsect
