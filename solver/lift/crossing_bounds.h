// Bounds of a region on the curve of two polynomials in space. Internal to solver/;
// docs/method-equations.md, section 17.17.
#pragma once

#include <exsect/geometry/surface_region.h>

#include <vector>

#include "lift/crossing_branches.h"

namespace exsect {

struct CrossingBound {
  SpacePolynomial form;
  SpacePolynomial where;
  /// With the signs of the form, and of `where`, on common points of which the slope is not 0.
  BivariatePolynomial below;
  BivariatePolynomial where_below;
  std::vector<Polynomial> norms;  // of the form, by branches; 0 if it vanishes along one
};

std::vector<CrossingBound> crossing_bounds(const CrossingBranches& branches, const SurfaceRegion& region);

/// Whether a point with these signs of the bounds is in the region.
bool is_in_region(const SurfaceRegion& region, const std::vector<int>& signs);

}  // namespace exsect
