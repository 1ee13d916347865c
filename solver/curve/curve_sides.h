// On which side of a plane curve its polynomial is positive. Internal to solver/; docs/method-equations.md,
// section 17.4.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/solver/curve_graph.h>
#include <exsect/solver/intersection_graph.h>

namespace exsect {

/// The signs of f beside the arc of the graph of f = 0; on a side of the square one of them is that of f
/// beyond it.
SideSigns signs_beside(const BivariatePolynomial& f, const CurveGraph& curve, const CurveBranch& arc);

/// The sign of f around an isolated point of f = 0, in the square: -1 or 1.
int sign_around(const BivariatePolynomial& f, const CurveNode& node);

}  // namespace exsect
