// An equation of space on a patch and on a line: what is left of it in their parameters.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/geometry/space_polynomial.h>

namespace exsect {

/// X_4^e f(X/X_4) (17.2) for the total degree e of f, u in the place of r and v in that of s; bidegree at
/// most (e m, e n). X_4 > 0 on the square, so it has the zeros and the signs of f(x(u,v)) there.
BivariatePolynomial pull_back(const SpacePolynomial& f, const RationalPatch& x);

/// f(origin + t direction), a polynomial in t.
Polynomial pull_back(const SpacePolynomial& f, const Point& origin, const Point& direction);

}  // namespace exsect
