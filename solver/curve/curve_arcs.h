// The arcs of a plane algebraic curve f(u,v) = 0 in the unit square and how they hang together. Exact.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/real_algebraic.h>

#include <vector>

namespace exsect {

/// A piece of the curve over the open interval between two neighbouring events: the graph of a function of u.
struct CurveArc {
  std::size_t gap;
  /// Isolates the arc's v among all roots at the sample of its gap: open, or a single rational number.
  RationalInterval v;
};

/// Between event i and event i + 1 the number of points over u does not change.
struct CurveGap {
  Rational sample;
  std::vector<std::size_t> arcs;  // ascending in v
};

enum class MeetingKind {
  passes,      // one arc from each side: one smooth or singular branch
  folds,       // two arcs from one side
  ends,        // one arc, on a side of the square
  crosses,     // three or more arcs that meet in one point, exactly
  unresolved,  // three or more arcs that meet or come very near each other
};

/// Arcs that come together over an event.
struct CurveMeeting {
  MeetingKind kind;
  RationalInterval v;  // the strip it lies in
  std::vector<std::size_t> left;
  std::vector<std::size_t> right;
};

struct CurveEvent {
  /// A closed interval with the event in it and no other one; a single number for the sides u = 0 and u = 1
  /// and wherever the event is known to be rational.
  RationalInterval u;
  /// As a root of Res_v(f, f_v); 0 for others: sides of the square, and those asked for.
  int multiplicity;
  /// The interval is an extra one with several turning values in it: closed curves inside are not seen.
  bool is_crowded;
  std::vector<CurveMeeting> meetings;  // ascending in v
};

struct CurveArcs {
  std::vector<CurveEvent> events;  // ascending; the first is u = 0, the last is u = 1
  std::vector<CurveGap> gaps;      // one fewer
  std::vector<CurveArc> arcs;
  std::vector<RealAlgebraic> vertical;  // u of the lines u = const in [0,1] that belong to the curve
};

/// The curve in [0,1]^2, u in the place of r and v in that of s. Complete but for two things: isolated points
/// of the curve are not found (each lies over an event of multiplicity at least 2), and `unresolved`
/// meetings. `extra`: intervals of positive length in (0,1) that become events besides the turning values and
/// the points on the sides (13.1). Throws std::domain_error for f = 0, if f has a multiple factor that
/// contains v, or if a side v = 0 or v = 1 belongs to the curve.
CurveArcs curve_arcs(const BivariatePolynomial& f, const std::vector<RationalInterval>& extra = {});

/// Connected groups of the arcs with kept[arc]; the others count as if they were not there.
struct CurveComponent {
  std::vector<std::size_t> arcs;
  bool closed;    // every end of every arc meets exactly one other kept arc
  bool branched;  // has a meeting of three or more kept arcs
};
std::vector<CurveComponent> components(const CurveArcs& curve, const std::vector<bool>& kept);

}  // namespace exsect
