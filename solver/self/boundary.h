// Where a patch meets itself with a parameter on a side of its square. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/certified_point.h>
#include <exsect/solver/result.h>

#include <array>
#include <optional>
#include <vector>

#include "shape/injective_rectangle.h"

namespace exsect {

/// Pairs that form an arc with a parameter on a side: all of them have `on`. from, to: indices of points; an
/// arc may also end in a cuspidal point, where the two points of the pair agree.
struct GluedArc {
  std::size_t from;
  std::optional<std::size_t> to;
  std::optional<std::array<Rational, 2>> cusp;  // instead of `to`
  std::vector<Side> on;
  Parameter along;  // on which the arc is a graph
  int direction;    // +1: ascending from `from` on; -1: descending
};

/// The pairs x(u1,v1) = x(u2,v2) with at least one of the four parameters 0 or 1, as points (u,v,r,s) =
/// (u1,v1,u2,v2), apart from those with both points on one folded straight side and the inner points of
/// `arcs`. Invariant: with a point the exchanged one (u2,v2,u1,v1) is in the list, points[mate[i]] is
/// points[i] exchanged; pairwise disjoint boxes. If `problems` is empty the list holds all such pairs. Of an
/// arc and its exchanged one only one is listed.
struct SelfBoundary {
  std::vector<CertifiedPoint> points;
  std::vector<std::size_t> mate;
  std::vector<GluedArc> arcs;
  std::vector<Incomplete> problems;
};

/// The four lines on the sides against the patch itself: plane and cylinder of the line u = c, pulled back,
/// have the factor r - c; what is left has the eliminant of degree 10 (method, section 7.1). If a side lies
/// on the patch in part, apart from itself, all arcs and points are those of 6.2 for the patch and itself.
SelfBoundary self_boundary(const BezierPatch& x, const InjectiveRectangles& injective);

}  // namespace exsect
