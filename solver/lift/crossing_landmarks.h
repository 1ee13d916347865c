// The points in which the arcs of the curve of two polynomials begin and end. Internal to solver/;
// docs/method-equations.md, section 17.15.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lift/crossing_branches.h"
#include "lift/crossing_star.h"
#include "lift/space_zero.h"

namespace exsect {

/// lowest, highest: a turning point of u. entry, exit: on a plane u = const, from which an arc begins with
/// growing u, or which it ends in.
enum class LandmarkKind { lowest, highest, entry, exit };

struct CrossingLandmark {
  SpaceZero zero;
  LandmarkKind kind;
  std::optional<std::size_t>
      star;            // on whose window's end it lies; else entry and exit are where u is cut off
  std::size_t branch;  // the only one through it
  int upward;  // u grows along grad f x grad g of the branch, 1, or against it, -1; 0 at turning points
};

struct LandmarkStar {
  CrossingStar star;
  CrossingBox point;  // of its centre
  bool is_singular;   // the curve is
};

/// Invariant, if there is no obstacle: the curve consists of the stars, of one arc from each entry to an exit
/// or a highest landmark, of two from each lowest one to such, and of arcs that go on to infinity from
/// entries and exits beside stars.
struct CrossingLandmarks {
  std::string obstacle = {};  // why they are not known
  double extent = 0;          // about the size of all
  double tolerance = 0;       // for this extent
  std::vector<CrossingLandmark> landmarks = {};
  std::vector<LandmarkStar> stars = {};
};

CrossingLandmarks crossing_landmarks(const CrossingBranches& branches,
                                     const std::function<double(double)>& tolerance);

}  // namespace exsect
