// A patch as polylines need it: points in doubles with bounds of their errors, and bounds of its derivatives.
// Internal to solver/; docs/method.md, section 17.4.
#pragma once

#include <exsect/algebra/ball.h>
#include <exsect/geometry/rational_patch.h>

#include <array>
#include <vector>

namespace exsect {

/// Upper bounds of the lengths of derivatives of x(u,v) on [0,1]^2.
struct PatchRates {
  double u, v, uu, uv, vv;
};

/// A point of space in doubles, and a bound of its distance from the true one.
struct DrawnPoint {
  std::array<double, 3> point;
  double error;
};

class DrawnPatch {
 public:
  /// Throws BeyondDoubles if the patch lies beyond the range of doubles.
  explicit DrawnPatch(const RationalPatch& patch);

  /// The largest edge of its box.
  double extent() const { return extent_; }
  const PatchRates& rates() const { return rates_; }
  /// The error covers all points whose parameters are in the balls.
  DrawnPoint at(const DoubleBall& u, const DoubleBall& v) const;
  /// A bound of the distance between x(p(t)) and the chord of its ends, for a segment p of the square.
  double chord_bound(double du, double dv) const;

 private:
  std::array<double, 3> centre_;
  double extent_;
  PatchRates rates_;
  int m_, n_;
  std::array<std::vector<DoubleBall>, 4> components_;  // about the centre; u^i v^j at i (n+1) + j
};

}  // namespace exsect
