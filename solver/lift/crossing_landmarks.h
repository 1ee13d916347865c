// The points in which the arcs of the curve of two polynomials begin and end. Internal to solver/;
// docs/method-equations.md, section 17.15.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lift/crossing_bounds.h"
#include "lift/crossing_star.h"
#include "lift/space_zero.h"

namespace exsect {

/// lowest, highest: a turning point of u. entry, exit: on a plane u = const, from which an arc begins with
/// growing u, or which it ends in. passage: where the curve crosses a bound.
enum class LandmarkKind { lowest, highest, entry, exit, passage };

struct CrossingLandmark {
  SpaceZero zero;
  LandmarkKind kind;
  std::optional<std::size_t>
      star;            // on whose window's end it lies; else entry and exit are where u is cut off
  std::size_t branch;  // the only one through it
  int upward;  // u grows along grad f x grad g of the branch, 1, or against it, -1; 0 at turning points
  std::size_t bound = 0;  // of a passage
};

struct LandmarkStar {
  CrossingStar star;
  CrossingBox point;                  // of its centre
  bool is_singular;                   // the curve is
  std::vector<int> signs = {};        // of the bounds in the centre
  std::vector<int> where_signs = {};  // and of their `where`
};

/// Invariant, if there is no obstacle: the curve consists of the stars, of one arc from each entry to an exit
/// or a highest landmark, of two from each lowest one to such, and of arcs that go on to infinity from
/// entries and exits beside stars. One arc
/// ends in each passage, and one begins there. Inside of arcs no bound is 0.
struct CrossingLandmarks {
  std::string obstacle = {};        // why they are not known
  bool asks_for_quadratic = false;  // of the projection, whose slope is 0 in a centre
  double extent = 0;                // about the size of all
  double tolerance = 0;             // for this extent
  std::vector<CrossingLandmark> landmarks = {};
  std::vector<LandmarkStar> stars = {};
};

/// With the bounds of these branches.
CrossingLandmarks crossing_landmarks(const CrossingBranches& branches,
                                     const std::vector<CrossingBound>& bounds,
                                     const std::function<double(double)>& tolerance);

}  // namespace exsect
