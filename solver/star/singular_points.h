// The points of the intersection that the tracer cannot pass: singular points, tangential boundary points,
// points where a patch is singular.
// Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <functional>
#include <vector>

#include "star/star_neighbourhood.h"
#include "trace/exchanging_symmetry.h"
#include "trace/pair_system.h"

namespace exsect {

/// What is known about a pair before its singular points are looked for.
struct SingularPointProblem {
  const BezierPatch& x;
  const BezierPatch& y;
  const std::vector<CertifiedPoint>& boundary;  // all isolated points on sides
  const std::vector<bool>& on_side_arc;         // which of them are ends of arcs that lie on sides
  const std::vector<CertifiedPoint>& pinches;   // pinch_points(x, y)
  double tolerance;                             // of polylines, patches scaled to unit size
  Parameter sampled;                            // no star contains a point over a sample
  const std::vector<Rational>& samples;
  /// The turning values of any sweep, computed once; empty if not defined.
  std::function<const std::optional<TurningValues>&(Parameter)> turning;
  std::array<std::size_t, 4> coincident;  // coincident_parameters(x, y)
  SymmetryOf symmetry;
  StopRequest stop;  // then the stars found so far are all
};

/// Disjoint stars around the multiple points over multiple rational turning values of all four sweeps that
/// may be singular, around the boundary points where the tangent may lie in a side, and around pinch points.
/// Points for which no star can be proved are left out; the tracer then fails there.
template <class Ball>
std::vector<StarNeighbourhood> singular_stars(const SingularPointProblem& problem,
                                              const PairSystem<Ball>& system);

}  // namespace exsect
