// Where two surfaces through a curve meet besides the curve (docs/method-implicit.md, 10.6).
#pragma once

#include <exsect/implicit/space_curve_surfaces.h>

#include <optional>
#include <vector>

namespace exsect {

/// A group of neighbouring cells in which the surfaces may meet outside the tube around the curve.
struct FurtherBranch {
  SpaceBox box;
  /// A box inside which the surfaces are proved to meet in a point that is not on the curve; nothing if no
  /// such point was proved.
  std::optional<SpaceBox> point;
};

/// Outside the boxes of `branches` the surfaces meet in `box` only in the tube. The tube is a union of boxes
/// around the curve, extended beyond its ends as far as its axis coordinate stays monotone; in it they meet
/// in at most one point for each value of that coordinate (10.17), on the curve or its extension if both
/// vanish there. Without a tube every cell where the surfaces may meet belongs to a branch.
struct FurtherBranches {
  std::vector<FurtherBranch> branches;
  bool has_tube;
};

/// The box is divided into 2^depth cells along each side, 1 <= depth <= 7; cells are excluded by the signs of
/// Bernstein coefficients. Throws std::invalid_argument for another depth or an empty box.
FurtherBranches further_branches(const SurfacePair& surfaces, const BezierCurve& curve, int axis,
                                 const SpaceBox& box, int depth = 5);

}  // namespace exsect
