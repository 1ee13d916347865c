// The pairs of one point of space in a small rectangle around a pinch point, in doubles. Internal to solver/;
// docs/method-doubles.md, section 14.17.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <optional>
#include <utility>

#include "self/pinch_bounds.h"

namespace exsect {

/// Of a patch x over the unit square, with the pairs w + t (1,m), w - t (1,m) of one point, or those with the
/// parameters exchanged. Invariant: all pairs of different parameters with one point have a slope m of
/// this kind, for every t >= 0 there is at most one, t = 0 standing for x_u + m x_v = 0, and these
/// form smooth curves that are graphs over q = t^2 <= 1/4.
class PinchProof {
 public:
  /// Empty unless all of this is proved. `origin`: near the patch.
  static std::optional<PinchProof> of(const RationalPatch& patch, const Point& origin);

  /// t is half the difference of the second parameters of the pair, not of the first ones.
  bool exchanged() const { return exchanged_; }
  /// The first (0), second (1) parameters of both points of a pair are strictly monotone along a curve.
  bool is_monotone(std::size_t parameter) const { return monotone_[exchanged_ ? 1 - parameter : parameter]; }
  /// The same if the derivative by the other parameter is known to be 0 in the pinch point (14.74).
  bool is_monotone_from_rest(std::size_t parameter) const;
  /// What pairs with both points in the square do next to the pinch point, if that is known to lie where the
  /// parameter (0 or 1) has the value 0 or 1 (14.73): `none` are there, or one curve `begins` in it, along
  /// which this parameter of both points is strictly monotone, or one runs `along` this side, with both
  /// points on it. `rests`: the derivative along the side is 0 there. `is_straight`: so is the side, in
  /// space.
  enum class AtSide { unknown, none, begins, along };
  AtSide at_side(std::size_t parameter, int value, bool rests, bool is_straight) const;
  /// A bound of the second derivative of the point of space by q.
  double bend() const { return bend_; }

  /// A pair (u1,v1,u2,v2) and its point of space, from the origin.
  struct Place {
    std::array<DoubleBall, 4> pair;
    BallVector<DoubleBall> point;
  };
  /// That with half difference t >= 0, if there is one; empty if it is not found. `side`: what the other
  /// parameter of both points is known to be, if it is.
  std::optional<Place> at(double t, std::optional<double> side = std::nullopt) const;
  /// The point of space.
  BallVector<DoubleBall> point(const std::array<DoubleBall, 2>& at) const;

 private:
  using Ball = DoubleBall;
  using Vector = BallVector<DoubleBall>;
  explicit PinchProof(LocalDerivatives x, bool exchanged) : x_(std::move(x)), exchanged_(exchanged) {}

  bool prove();
  bool invert(const std::array<Vector, 3>& columns);
  void bound_curves(const CurveBounds& bounds);
  /// Bounds of |y|, if |y| <= |C value| + P |y|.
  std::array<double, 3> solved(const Vector& value) const;
  /// The difference of both points divided by 2 t.
  Vector value_at(const std::array<double, 3>& y, double t) const;
  bool improve(std::array<double, 3>& y, double t) const;

  LocalDerivatives x_;  // with exchanged parameters if `exchanged_`
  bool exchanged_;
  double guess_ = 0;                                   // of m
  Ball slopes_;                                        // m
  std::array<std::array<double, 3>, 3> rows_{};        // C
  std::array<double, 3> scale_{};                      // z
  std::array<double, 3> room_{};                       // at most z - P z, positive
  std::array<std::array<double, 3>, 3> deviations_{};  // P
  std::array<bool, 2> monotone_{};
  std::array<double, 3> speed_{};  // at least |y'|
  std::array<Ball, 3> drift_{};    // y'
  double bend_ = 0;
};

}  // namespace exsect
