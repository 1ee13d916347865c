// The translation and scaling that bring a pair of patches to unit size. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <array>

namespace exsect {

/// The translation and scaling of PairSystem: a space point is origin + 2^exponent * (scaled point). The
/// origin has double coordinates.
struct ModelFrame {
  std::array<double, 3> origin;
  long exponent;
};

/// Origin (with double coordinates) and power of two that bring both patches to unit size; `extent` is the
/// largest extent of the common bounding box.
struct ModelScale {
  ModelFrame frame;
  Point origin;
  double extent;
};

/// Throws BeyondDoubles if control points lie beyond the range of doubles.
ModelScale model_scale(const BezierPatch& x, const BezierPatch& y);

}  // namespace exsect
