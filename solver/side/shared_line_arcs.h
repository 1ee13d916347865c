// Arcs along a parameter line of each of the two patches: no tracing is needed. Internal to solver/.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <memory>
#include <vector>

#include "line/line_place.h"
#include "line/line_system.h"
#include "side/line_arcs.h"

namespace exsect {

/// A short rational number between a < b, not the middle or another one at which something may be special.
Rational rational_between(RealAlgebraic a, RealAlgebraic b);

/// The lines r = c and s = c with rational c that belong to the curve f(r,s) = 0, and the rest of it.
struct LinesOfCurve {
  std::vector<Rational> first;   // r = c
  std::vector<Rational> second;  // s = c
  BivariatePolynomial rest;
};
/// Requires f squarefree and not zero.
LinesOfCurve rational_lines(const BivariatePolynomial& f);

/// An exact point of the curve with a t in one of the system's pieces, and which of LineArcs::ends it is.
struct LineEvent {
  TriangularPoint at;
  std::size_t end;
  std::size_t piece;
  bool at_turn;  // t is in both pieces
};

/// The arcs along `lines`, `ends` those of the events, one or more on every piece of the system. Between two
/// neighbouring events on a line and a piece the system's lambda is strictly monotone, and inside the piece's
/// range throughout or nowhere. The polylines keep within `tolerance` where doubles can express that; that of
/// a line of the other patch is a parabola, so that nothing depends on whether the patches are regular.
std::vector<LineArc> arcs_on_lines(const LinePlace& place, const BezierPatch& patch,
                                   const std::shared_ptr<const LineSystem>& system, const LinesOfCurve& lines,
                                   const std::vector<LineEvent>& events,
                                   const std::vector<CertifiedPoint>& ends, double tolerance);

}  // namespace exsect
