// A parameter line against a patch as two equations in the patch's parameters: the general form behind every
// case.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/geometry/parameter_line.h>
#include <exsect/geometry/pull_back.h>
#include <exsect/solver/feasible_intervals.h>
#include <exsect/solver/line_query.h>

#include <vector>

#include "line/line_place.h"

namespace exsect {

/// A closed interval of the line's parameter t on which phi is strictly monotone.
struct MonotonePiece {
  RationalInterval t;
  RationalInterval lambda;  // phi of it
};

/// The carrier of the line (a parabola or a straight line) meets y where first = second = 0; lambda is the
/// coordinate along the carrier, and the point is the image of every t in [0,1] with phi(t) = lambda.
/// Conic: plane and cylinder, lambda = t. Straight or folded: two orthogonal planes, lambda = phi(t) monic of
/// degree 1 or 2.
struct LineSystem {
  BivariatePolynomial first;
  BivariatePolynomial second;
  BivariatePolynomial lambda;
  Polynomial phi;
  std::vector<MonotonePiece> pieces;  // one, or two for a folded line; they cover [0,1] in order
};

/// Throws std::domain_error for a line of shape point.
LineSystem line_system(const LineAndPatch& problem);

/// The values of phi over [0,1].
RationalInterval lambda_range(const LineSystem& system);

/// The t in the piece with phi(t) = lambda; requires lambda in piece.lambda.
RealAlgebraic preimage(const Polynomial& phi, const MonotonePiece& piece, const RealAlgebraic& lambda);

}  // namespace exsect
