// What is drawn of a surface of revolution in the half plane of r and z, in doubles.
#pragma once

#include "output/drawing/implicit_svg.h"
#include "output/text/revolution_output.h"

namespace exsect::cli {

struct HalfPlaneCurves {
  PlanePolyline profile;
  DrawnZeroSet own;                     // zeros of the profile's equation
  std::vector<PlanePolyline> mirrored;  // those of f(-r,z), where the method has them
};

/// The region of the result as it is seen.
PlaneView view_of(const Rectangle& region);

HalfPlaneCurves half_plane_curves(const ShownRevolution& shown);

}  // namespace exsect::cli
