// What the exact part of the sweep knows of a pair, for the tracer to join. Internal to solver/.
#pragma once

#include <exsect/solver/certified_point.h>
#include <exsect/solver/result.h>

#include <optional>
#include <vector>

#include "eliminant/exact_pair.h"
#include "star/star_neighbourhood.h"
#include "trace/subdivision.h"

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
  ExactPair& pair;
  std::vector<LandmarkPoint> landmarks = {};  // every intersection point on a side once; then all ports
  std::vector<StarNeighbourhood> stars = {};  // pairwise disjoint
  std::optional<TurningValues> turning = {};  // empty where no turning eliminant is defined
  std::vector<Rational> samples = {};         // of the sweep parameter
  std::vector<std::vector<CertifiedPoint>> fibres = {};  // exact, one per sample
  SettledRegion settled = {};                            // what a search may leave out
  bool quick = false;                                    // searches are cut short: stars may help
  bool exact = true;  // false: boundary points or fibres are known not to be complete
};

/// The point lies in the closed box of one of the sweep's stars.
bool in_star(const SweepData& sweep, const CertifiedPoint& point);

}  // namespace exsect
