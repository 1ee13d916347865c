// How fast a patch moves and bends. Internal to verify/; docs/method-verify.md, section 15, (15.5).
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>

namespace exsect {

/// On a square of parameters: |x - origin| <= reach, weight >= least_weight, |x_u|, |x_v| <= first, and
/// |x_uu|, |x_uv|, |x_vv| <= second. All are infinite, and the weight 0, if the denominator is not proved
/// positive there.
struct DerivativeBounds {
  double reach = 0;
  double least_weight = 0;
  std::array<double, 2> first{};
  std::array<double, 3> second{};
};

/// On [-margin, 1 + margin]^2. The origin has double coordinates; the weights are those of `patch` times
/// `scale`.
DerivativeBounds derivative_bounds(const RationalPatch& patch, const Rational& margin,
                                   const std::array<double, 3>& origin, const Rational& scale);

}  // namespace exsect
