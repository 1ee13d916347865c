// The proof that two patches meet along a side of one of them only, which crosses the other one on a straight
// line of its parameters. Internal to solver/; docs/method-doubles.md, section 14.7.
#pragma once

#include "filter/mean_derivatives.h"
#include "filter/side_path.h"

namespace exsect::filter {

/// A side on a line of the other patch, in doubles.
struct PathContact {
  SidePath path;
  SideView side;                              // not reversed
  std::array<std::array<double, 2>, 2> ends;  // of the path, centred, up to rounding
  AcrossField across;                         // of the side's patch
};
PathContact path_contact(const SidePath& path, const Pair& pair);

/// Around the line's points that belong to a part of the patch with the side.
Rectangle line_along(const PathContact& contact, const SideIntervals& on_owner);

/// True only if all solutions on the two parts are on the side, and on the line.
bool meet_on_line(const Pair& pair, const PathContact& contact, const Part& x, const Part& y);

/// False only if no point of the side that is on the line, in the square, belongs to both parts.
bool may_touch(const PathContact& contact, const Part& x, const Part& y);

}  // namespace exsect::filter
