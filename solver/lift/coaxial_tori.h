// Two tori about one axis: a simpler surface that has the same points on the one as the other. Internal to
// solver/; docs/method-equations.md, section 17.9.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include <optional>

namespace exsect {

/// A plane, cylinder or nappe of a cone about the axis of the torus; empty if no point is common, or if the
/// tori are one.
struct CoaxialSection {
  std::optional<ImplicitSurface> surface;
  bool is_same = false;
  bool is_reversed =
      false;  // on the first torus its equation has the other signs than that of the second one
};

/// What has the same common points with the first torus as the second torus has, of the same order of
/// contact. Empty unless the axes are one line and the radii of the circles in the middle have a rational
/// ratio.
std::optional<CoaxialSection> coaxial_section(const SurfaceData& first, const SurfaceData& second);

}  // namespace exsect
