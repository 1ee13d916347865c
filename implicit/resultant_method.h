// The intersection by elimination of one parameter of each patch: a plane curve with phantom branches, which
// are removed exactly (chapter 9.3; docs/method-implicit.md, section 13).
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/check_lines.h>
#include <exsect/solver/curve_arcs.h>

#include <optional>
#include <string>
#include <vector>

namespace exsect {

struct ResultantMethod {
  /// The squarefree part of g(u,r), the resultant with respect to v and s; u in the place of r, r in that of
  /// s.
  BivariatePolynomial curve;
  CurveArcs arcs;
  std::vector<bool> is_true;               // per arc: over it v and s are in [0,1]
  std::vector<CurveComponent> components;  // of the true arcs
  std::vector<CurveComponent> phantoms;    // of the others
  std::size_t certified_points;            // exact points that decided about the arcs
  /// Empty, or why there is no answer or not all of it.
  std::optional<std::string> incomplete;
};

/// g has bidegree (16,16) in general. Every arc of g = 0 between two events is true or phantom as a whole:
/// events are the turning values of g and the u of all boundary points. It is decided by one exact fibre per
/// gap. Isolated points of the intersection are not found by this method.
ResultantMethod intersect_by_resultant(const BezierPatch& x, const BezierPatch& y);

/// Roots r in [0,1] of g on the check lines: `points` are matched one to one by roots, `phantoms` is the
/// number of the others.
struct ResultantCheck {
  std::size_t points;
  std::size_t phantoms;
};
ResultantCheck check(const ResultantMethod& method, const std::vector<CheckLine>& lines);

}  // namespace exsect
