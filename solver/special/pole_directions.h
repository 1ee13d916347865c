// A pole blown up. Internal to solver/; docs/method-doubles.md, section 14.24.
#pragma once

#include <exsect/algebra/ball.h>
#include <exsect/algebra/tensor_bernstein.h>
#include <exsect/geometry/rational_patch.h>

#include <array>
#include <vector>

#include "curve/polynomial_vector.h"

namespace exsect {

/// f / a in (a,t). Requires f(0,t) = 0.
BivariatePolynomial divided_by_first(const BivariatePolynomial& f);

/// D of X - P X_4 = a D(a,t). Requires that the side (0,t) is the point P.
PolynomialVector pole_directions(const RationalPatch& x, const Point& p);

/// The coefficients of D(0,t), of which some may be 0.
std::vector<Point> directions_in_pole(const PolynomialVector& d);

/// Of the plane through the origin that holds all vectors, of which the first is not 0; zero if there is
/// none, or more than one.
Point common_normal(const std::vector<Point>& vectors);

/// Encloses the values of f there.
DoubleBall range_on(const BivariatePolynomial& f, const Rectangle& on);

/// The same of 1 / f; of infinite radius if f is not proved positive there.
DoubleBall inverse_range(const BivariatePolynomial& f, const Rectangle& on);

using EnclosedVector = std::array<DoubleBall, 3>;

}  // namespace exsect
