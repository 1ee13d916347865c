// Candidate curves as chains in space. Internal to solver/; docs/method.md, section 15.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/candidate.h>

#include "piece_tree.h"

namespace exsect {

/// A patch in doubles on a square of parameters, with bounds that hold for what is computed.
class PatchInDoubles {
 public:
  /// On [-margin, 1 + margin]^2, margin from 0 to 1.
  PatchInDoubles(const BezierPatch& patch, const Rational& margin);

  /// x(u,v), within rounding() of the exact point for u, v in [-1,2].
  SpacePoint operator()(double u, double v) const;
  double rounding() const { return rounding_; }
  /// |x(p) - x(q)| <= speed(0) |p_u - q_u| + speed(1) |p_v - q_v| on the square.
  double speed(std::size_t k) const { return speed_[k]; }
  /// At least |d2x/dt2| along t -> p + t (du,dv) in the square.
  double second_derivative(double du, double dv) const;
  /// True only if every point x(u,v), u, v in [0,1], is farther than `radius` from p.
  bool certainly_farther(const SpacePoint& p, double radius) const;

 private:
  std::array<std::array<SpacePoint, 3>, 3> power_;
  std::array<std::array<SpacePoint, 3>, 3> net_;
  double rounding_;
  std::array<double, 2> speed_;
  std::array<double, 3> second_;  // of x_uu, x_uv, x_vv
};

/// The curve in space as a chain whose bounds are at most `flat`, unless that takes more than 2^20 pieces.
Chain chain_in_space(const SplineCurve& curve, bool closed, double flat);
/// The curve of the parameter square, mapped into space by the patch; the curve's control points have to be
/// inside the patch's square.
Chain chain_on_patch(const SplineCurve& curve, bool closed, const PatchInDoubles& patch, double flat);

}  // namespace exsect
