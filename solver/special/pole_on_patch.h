// Where a pole, a side of a patch that is one point, lies on another patch. Internal to solver/;
// docs/method-doubles.md, section 14.24.
#pragma once

#include <exsect/algebra/triangular_point.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/intersection_graph.h>

#include <array>
#include <optional>

namespace exsect {

/// The side (0,t) of x is the point of y at one (r,s) in `at`, where y is regular: a rational place
/// of [0,1]^2, or a box inside of a width of at most 2^-80 around an irrational one, which is `exact`; y is
/// regular in its middle too.
struct PoleOnPatch {
  Point point;
  std::array<RationalInterval, 2> at;
  std::optional<TriangularPoint> exact = std::nullopt;
  bool is_rational() const { return !exact; }
};

/// The side (0,t) of x is one point.
bool is_pole(const RationalPatch& x);
/// This side of x, in u or v, is one point.
bool is_pole(const RationalPatch& x, const Side& side);
/// The other sides of x are not in this pole but in the corners they have in common with it.
bool is_pole_alone(const RationalPatch& x, const Side& pole);

/// Empty if the side is no point, or the point is not on y, exactly, or y is singular there.
std::optional<PoleOnPatch> pole_on_patch(const RationalPatch& x, const RationalPatch& y);

}  // namespace exsect
