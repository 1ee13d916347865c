// Bounds off the centre line of a tube: of the Jacobian, and of the arc's derivatives. Internal to solver/;
// docs/method.md, section 5.
#pragma once

#include <array>

#include "trace/tube_line.h"
#include "trace/tube_type.h"

namespace exsect {

/// By columns other than the axis, over the tube's half widths: |C D_j - 1|, or (`part`) its derivatives with
/// respect to tau.
template <class Ball>
std::array<Row3, 4> column_bounds(const Tube<Ball>& tube, const AlongLine& along, double SeriesBound::*part);

/// Fills in slope_error, second, second_error and space_second_derivative of a proved tube: w = p + l + e
/// with C F(p + l + e) = 0, and e' and e'' solve the equations differentiated once and twice.
template <class Ball>
void bound_derivatives(Tube<Ball>& tube, const AlongLine& along);

}  // namespace exsect
