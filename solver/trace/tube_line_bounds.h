// Bounds along the centre line of a tube. Internal to solver/.
#pragma once

#include "trace/tube_line.h"

namespace exsect {

/// Bounds of what is left, over the tube's reach, at most its scale.
template <class Ball>
AlongLine along_line(const Tube<Ball>& tube, const LineRemainder<Ball>& left);

}  // namespace exsect
