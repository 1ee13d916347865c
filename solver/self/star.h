// Neighbourhoods of single pairs of a self-intersection, singular ones and cuspidal points included, in which
// the pairs form a star of arcs. Internal to solver/; docs/method.md, section 7.6.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/certified_point.h>

#include <optional>
#include <vector>

#include "answer/stop_request.h"
#include "self/star_centres.h"
#include "star/star_neighbourhood.h"

namespace exsect {

/// A star of pairs (u1,v1,u2,v2) = (u,v,r,s). At a cuspidal centre, where the two points of a pair agree,
/// both orders of every arc are in the box and the ports are those of one order.
struct SelfStar {
  /// A folded line, u or v (`fixed`: 0 or 1) constant, on a side of the square or not.
  struct FoldedArc {
    std::size_t fixed;
    RealAlgebraic constant;
    std::optional<int> side;
  };

  StarNeighbourhood star;
  ParameterBox
      surroundings;  // star.box or more: all pairs are on the arcs of the star and what continues them
  std::vector<std::optional<FoldedArc>> folded;  // for each port, if its arc runs along such a line
  bool cuspidal;
  std::optional<std::size_t> landmark;  // the boundary point that is the centre
};

struct SelfStarProblem {
  const BezierPatch& x;
  const std::vector<CertifiedPoint>& boundary;  // SelfBoundary::points
  const std::vector<SelfCentre>& centres;
  const SelfValues& values;
  double tolerance;  // of polylines, the patch scaled to unit size
  StopRequest stop;
};

/// Stars with disjoint boxes, in either order of the pairs, around centres, and where a folded line ends in
/// glued sides. Centres for which no
/// star can be proved are left out.
std::vector<SelfStar> self_stars(const SelfStarProblem& problem);

}  // namespace exsect
