// In which directions curves of a self-intersection leave the landmarks. Internal to solver/.
#pragma once

#include <vector>

#include "self/places.h"
#include "trace/landmark_tangent.h"

namespace exsect {

/// Directions of the tangent field; `certain`: a curve does leave in each of them.
struct LeavingDirections {
  std::vector<int> signs = {1, -1};
  bool certain = true;
};

/// The directions in which curves leave landmarks: into the domain from a boundary point, away from the
/// centre of its star from a port, away from the cuspidal point from a gate. `found`: its landmarks may still
/// grow, and its traces in the charts.
template <class Ball>
class SelfDirections {
 public:
  SelfDirections(const SelfSystem<Ball>& system, const ExactPlaces& exact, const SelfCurves<Ball>& found)
      : system_(system), exact_(exact), boundary_(exact.boundary), found_(found) {}

  LeavingDirections at(std::size_t landmark) const;

  /// Once all landmarks are there. From the ends of the lines exact.folds nothing else leaves.
  void start();
  /// A curve leaves the landmark in this direction, and the exchanged one the exchanged landmark: there T is
  /// the opposite.
  void use(std::size_t landmark, int sign);
  /// The directions in which known curves leave.
  const std::vector<int>& used(std::size_t landmark) const { return used_[landmark]; }

  /// T at a landmark; nothing for -1.
  TangentSigns signs_at(int landmark) const;
  bool is_boundary(std::size_t landmark) const { return landmark < boundary_.points.size(); }
  /// The landmark of the exchanged pair.
  std::size_t mate(std::size_t landmark) const;

 private:
  LeavingDirections entering(std::size_t landmark) const;
  LeavingDirections outward(std::size_t landmark) const;
  int leaving(const ChartTrace<Ball>& trace) const;
  void use_ends(const MultipleFold& fold);

  const SelfSystem<Ball>& system_;
  const ExactPlaces& exact_;
  const SelfBoundary& boundary_;
  const SelfCurves<Ball>& found_;
  std::vector<std::vector<int>> used_;
};

}  // namespace exsect
