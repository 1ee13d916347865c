// An arc of pairs along sides, from star to star. Internal to solver/.
#pragma once

#include "self/directions.h"
#include "self/places.h"

namespace exsect {

/// A landmark and the direction of the tangent field in which an arc leaves it.
struct GluedStep {
  std::size_t landmark;
  int sign;
};

/// Where the parts of a glued arc start and end: at its ends, and at the stars around singular pairs on it.
template <class Ball>
class GluedSteps {
 public:
  GluedSteps(const SelfSystem<Ball>& system, const ExactPlaces& exact, const SelfCurves<Ball>& found,
             const SelfDirections<Ball>& directions)
      : system_(system), exact_(exact), found_(found), directions_(directions) {}

  /// From arc.from, or from the star around it. Empty if that is not clear.
  std::optional<GluedStep> first(const GluedArc& arc) const;
  /// Whether the part that ends in this landmark is the last one.
  bool is_last(const GluedArc& arc, int landmark) const;
  /// Behind the star in whose port a part has ended.
  std::optional<GluedStep> next(const GluedArc& arc, int landmark) const;

 private:
  std::optional<GluedStep> from_port(const GluedArc& arc, std::size_t star, bool exchanged,
                                     std::optional<std::size_t> arrived) const;
  bool is_on(const GluedArc& arc, std::size_t port) const;
  bool is_around(std::size_t star, bool exchanged, std::size_t boundary_point) const;

  const SelfSystem<Ball>& system_;
  const ExactPlaces& exact_;
  const SelfCurves<Ball>& found_;
  const SelfDirections<Ball>& directions_;
};

}  // namespace exsect
