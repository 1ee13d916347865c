// All curves of the intersection, traced from boundary points, fibres and searches, with the proof that none
// is missing. Internal to solver/.
#pragma once

#include <exsect/solver/certified_point.h>
#include <exsect/solver/line_patch.h>
#include <exsect/solver/result.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "boundary_lines.h"
#include "contact_graph.h"
#include "critical_values.h"
#include "exchanging_symmetry.h"
#include "star_neighbourhood.h"
#include "subdivision.h"
#include "trace_graph.h"

namespace exsect {

/// Where traces may start and end: an intersection point on a side of a square, or a port of a star.
struct LandmarkPoint {
  CertifiedPoint point;
  /// The star (index in SweepData::stars) whose port or centre this is.
  std::optional<std::size_t> star;
  int side = 0;                     // of the port; 0: not a port
  Parameter across = Parameter::u;  // of the port
  /// Arcs that lie on sides end here; other curves do so only in a star.
  bool on_side_arc = false;
};

/// The exact part of the sweep: what the tracer joins.
struct SweepData {
  std::vector<LandmarkPoint> landmarks;             // every intersection point on a side once; then all ports
  std::vector<StarNeighbourhood> stars;             // pairwise disjoint
  std::optional<TurningValues> turning;             // empty where no turning eliminant is defined
  std::vector<Rational> samples;                    // of the sweep parameter
  std::vector<std::vector<CertifiedPoint>> fibres;  // exact, one per sample
  std::function<LinePoints(const LineQuery&)> line;  // line_points of the pair
  /// All lines of the other patch that are one point of this line, at a value along it, are sides of the
  /// square; false: or not known.
  std::function<bool(const LineQuery&, const RealAlgebraic&)> is_on_sides;
  std::function<bool(const CertifiedPoint&, Parameter, const Rational&)> has_value;  // false: or not known
  TurningValuesOf turning_of;
  /// Components of T that are known to vanish at a point.
  std::function<std::array<bool, 4>(const CertifiedPoint&)> zero_tangent;
  /// KnownTangent::common_zero.
  std::function<std::optional<ParameterBox>(const ParameterBox&, std::size_t, std::size_t)> common_zero;
  std::array<std::size_t, 4> coincident;            // coincident_parameters(x, y)
  std::array<std::optional<std::size_t>, 2> plane;  // plane_coordinates(x, y)
  SymmetryOf symmetry;                              // unless empty
  SettledRegion settled;                            // what a search may leave out
  bool quick = false;                               // searches are cut short: stars may help
  bool exact = true;  // false: boundary points or fibres are known not to be complete
};

/// The curves traced in one arithmetic, and what it could not decide.
template <class Ball>
struct TracedCurves {
  std::vector<AnalysedTrace<Ball>> curves;
  std::vector<AnalysedContact<Ball>> contacts;  // curves along which the patches touch
  std::vector<int> isolated;                    // boundary points at which no curve enters the domain
  std::vector<Incomplete> problems;
  long searched_boxes = 0;
  bool cut_short = false;  // a problem is left because of SweepData::quick
};

/// How many of the curves pass through a box.
template <class Ball>
int curves_through(const TracedCurves<Ball>& traced, const BallPoint<Ball>& box) {
  return static_cast<int>(
      std::count_if(traced.curves.begin(), traced.curves.end(),
                    [&](const AnalysedTrace<Ball>& curve) { return passes_through(curve.trace, box); }));
}
template <class Ball>
int contacts_through(const TracedCurves<Ball>& traced, const BallPoint<Ball>& box) {
  return static_cast<int>(std::count_if(
      traced.contacts.begin(), traced.contacts.end(),
      [&](const AnalysedContact<Ball>& contact) { return passes_through(contact.curve, box); }));
}

/// The curve turns in this parameter at the point.
template <class Ball>
bool turns_in(const TurningPoint<Ball>& point, std::size_t parameter) {
  return std::count(point.parameters.begin(), point.parameters.end(), parameter) > 0;
}

/// Traces every curve. `landmarks` are sweep.landmarks enclosed in boxes of width at most `width`. If no
/// problem is reported, the curves and isolated points are the whole intersection (provided `sweep.exact`):
/// every arc with ends starts at a boundary point or a star; closed curves meet a fibre (or are found by
/// search_closed_curves where there is no eliminant); curves along which the patches touch meet a fibre too,
/// or are parameter lines; and at every sample the traced curves and the exact fibre are in bijection.
template <class Ball>
TracedCurves<Ball> trace_curves(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks,
                                const SweepData& sweep, const Rational& width, const StopRequest& stop);

bool in_star(const SweepData& sweep, const CertifiedPoint& point);

/// A small box for a report around a place known in doubles.
ParameterBox around(const std::array<double, 4>& where);

/// The point's box at `width` as balls.
template <class Ball>
BallPoint<Ball> enclose(const CertifiedPoint& point, const Rational& width);

}  // namespace exsect
