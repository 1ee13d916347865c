// Names and points of a line query as they are shown.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/line_patch.h>

#include <array>
#include <vector>

namespace exsect::cli {

/// "conic", "straight", "folded", "point", "plane cubic", "twisted cubic".
const char* name(LineShape shape);

/// The other parameter of the same patch: what runs along the line `p = constant`.
Parameter partner(Parameter p);

/// A certified point with a box at most 2^-64 wide, the middle of that box, and the middle's point of space.
struct ShownPoint {
  CertifiedPoint point;
  std::array<double, 4> parameters;
  std::array<double, 3> space;
};

/// The isolated points of the query in their order; x is the patch of (u,v).
std::vector<ShownPoint> shown_points(const LinePoints& solution, const RationalPatch& x);

}  // namespace exsect::cli
