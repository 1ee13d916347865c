// Isolated common zeros of the two polynomials of a line. Internal to solver/.
#pragma once

#include "line/line_curve.h"

namespace exsect {

/// The isolated points of S, f squarefree.
std::vector<IsolatedPoint> isolated_points(const BivariatePolynomial& f, const BivariatePolynomial& lambda,
                                           const RationalInterval& range);

}  // namespace exsect
