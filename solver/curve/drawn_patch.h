// A patch as polylines need it: points in doubles with bounds of their errors, and bounds of its derivatives.
// Internal to solver/; docs/method-equations.md, section 17.4.
#pragma once

#include <exsect/algebra/ball.h>
#include <exsect/geometry/rational_patch.h>

#include <array>
#include <optional>
#include <vector>

namespace exsect {

/// Upper bounds of the lengths of derivatives of x(u,v) on a rectangle.
struct PatchRates {
  double u, v, uu, uv, vv;
};

/// A bound of the distance between x(p(t)) and the chord of its ends, for a segment p of the rectangle
/// (17.3).
double chord_bound(const PatchRates& rates, double du, double dv);

/// A point of space in doubles, and a bound of its distance from the true one.
struct DrawnPoint {
  std::array<double, 3> point;
  double error;
};

/// Not to be shared by threads.
class DrawnPatch {
 public:
  /// Throws BeyondDoubles if the patch lies beyond the range of doubles.
  explicit DrawnPatch(const RationalPatch& patch);

  /// The largest edge of its box.
  double extent() const { return extent_; }
  /// On [0,1]^2.
  const PatchRates& rates() const { return rates_; }
  /// On [u0,u1] x [v0,v1], as far as it is in the square; u0 <= u1, v0 <= v1.
  PatchRates rates_in(double u0, double u1, double v0, double v1) const;
  /// The error covers all points whose parameters are in the balls.
  DrawnPoint at(const DoubleBall& u, const DoubleBall& v) const;

 private:
  static constexpr int kCells = 16;  // along each side of the square

  PatchRates rates_of_cell(int i, int j) const;

  std::array<double, 3> centre_;
  double extent_;
  PatchRates rates_;
  mutable std::vector<std::optional<PatchRates>> cells_;  // i kCells + j, those that were asked for
  int m_, n_;
  std::array<std::vector<DoubleBall>, 4> components_;  // about the centre; u^i v^j at i (n+1) + j
};

}  // namespace exsect
