// A patch in doubles, with bounds of what is computed. Internal to verify/; docs/method-verify.md,
// section 15.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>

#include "piece_tree.h"

namespace exsect {

/// A patch in doubles on a square of parameters, with bounds that hold for what is computed. All bounds are
/// infinite if the denominator is not proved positive on that square.
class PatchInDoubles {
 public:
  /// On [-margin, 1 + margin]^2, margin from 0 to 1.
  PatchInDoubles(const RationalPatch& given, const Rational& margin);

  /// x(u,v), within rounding() of the exact point for u, v in the square.
  SpacePoint operator()(double u, double v) const;
  double rounding() const { return rounding_; }
  /// |x(p) - x(q)| <= speed(0) |p_u - q_u| + speed(1) |p_v - q_v| on the square.
  double speed(std::size_t k) const { return speed_[k]; }
  /// At least |d2x/dt2| along t -> p + t (du,dv) in the square.
  double second_derivative(double du, double dv) const;
  /// True only if every point x(u,v), u, v in [0,1], is farther than `radius` from p.
  bool certainly_farther(const SpacePoint& p, double radius) const;

 private:
  using Vector4 = std::array<double, 4>;
  /// Those of u^i v^j, or control points, at 4 i + j; the last entry is the weight.
  using Net = std::array<Vector4, 16>;

  /// Of the first three entries, as a length, and of the last one.
  struct Error {
    double vector = 0;
    double weight = 0;
  };

  void bound_derivatives(const RationalPatch& patch, const Rational& margin, const Error& error);
  /// A lower bound of the distance of p from the piece with this net; negative where a weight is not proved
  /// positive.
  double distance_from_hull(const SpacePoint& p, const Net& net) const;
  std::array<Net, 2> halves(const Net& net, bool first) const;

  std::size_t m_;
  std::size_t n_;
  bool polynomial_;
  Net power_{};
  Net net_{};
  Error net_error_;  // of the control points of nets halved from `net_`
  double rounding_;
  std::array<double, 2> speed_{};
  std::array<double, 3> second_{};  // of x_uu, x_uv, x_vv
};

}  // namespace exsect
