// Certified pieces of curves along which the two patches touch. Internal to solver/.
//
// Along such a curve F = 0 has a Jacobian of rank 2 and no tube of tube.h exists. It is a regular curve of
// the three equations Phi = (F_a, F_b, T_k) = 0 (6.4): two coordinates of F and one component of the tangent
// field, which vanishes there (docs/method.md, section 6.6).
#pragma once

#include <exsect/algebra/ball.h>

#include <array>
#include <optional>

#include "trace/straight_tube.h"

namespace exsect {

/// Invariant (proved by certify_tangential_tube): a straight tube of Phi = 0 with contraction <= 1/2, whose
/// arc has |w_i - p_i - tau d_i| <= core. If F = 0 along it, then F has no other zero in the core of the
/// tube, the points with |w_i - p_i - tau d_i| <= core.
template <class Ball>
struct TangentialTube : StraightTube<Ball> {
  std::array<std::size_t, 2> rows;  // a, b
  Matrix3 preconditioner;           // C
  double core;
  std::array<double, 4> slope_error;  // bounds of |w_i'(tau) - d_i|
};

/// The tube around `centre` (its midpoints are used) over tau in [-reach, reach] with the half width reach;
/// empty if it cannot be proved. The axis is the one of steepest direction unless given.
template <class Ball>
std::optional<TangentialTube<Ball>> certify_tangential_tube(const PairSystem<Ball>& system,
                                                            const BallPoint<Ball>& centre, double reach,
                                                            std::optional<std::size_t> axis = {});

/// Approximate Newton correction of the coordinates other than `axis` towards Phi = 0 (an estimate, not a
/// proof); empty if the Jacobian is numerically singular.
template <class Ball>
std::optional<BallPoint<Ball>> corrected_to_contact(const PairSystem<Ball>& system,
                                                    const BallPoint<Ball>& start, std::size_t axis,
                                                    int steps);

/// An enclosure of the arc's point at tau, |tau| <= reach.
template <class Ball>
BallPoint<Ball> point_at(const PairSystem<Ball>& system, const TangentialTube<Ball>& tube, double tau);

/// Enclosures over all of the arc between two offsets: parameters w, and w' with respect to tau.
template <class Ball>
struct ArcEnclosure {
  BallPoint<Ball> at;
  BallPoint<Ball> slope;
};
/// True only if the whole box lies in the core.
template <class Ball>
bool contains(const TangentialTube<Ball>& tube, const BallPoint<Ball>& box);
/// True only if no point of the box is in the region, where all of the arc lies.
template <class Ball>
bool excludes(const TangentialTube<Ball>& tube, const BallPoint<Ball>& box);

}  // namespace exsect
