#include "output/drawing/space_implicit_svg.h"

#include "output/drawing/implicit_svg.h"

namespace exsect::cli {

std::string space_implicit_svg(const SpaceImplicit& implicit, const BezierCurve& curve,
                               const std::string& title) {
  const std::array<int, 2> axes = other_axes(implicit);
  const auto name = [](int axis) { return std::string(1, "xyz"[axis]); };
  return planar_pair_svg(implicit.projections[0], curve.projected(implicit.axis, axes[0]),
                         {name(implicit.axis), name(axes[0])}, implicit.projections[1],
                         curve.projected(implicit.axis, axes[1]), {name(implicit.axis), name(axes[1])},
                         title);
}

}  // namespace exsect::cli
