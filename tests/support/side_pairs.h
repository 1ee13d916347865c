// Seeded pairs of patches of which a side of one lies on the other: neighbours in B-spline surfaces, parts of
// sides, sheets that stand on others.
#pragma once

#include "support/random_pairs.h"

namespace exsect::side_pairs {

using random_pairs::Generator;
using random_pairs::Pair;

/// Neighbours in a biquadratic B-spline surface with uniform or other knots and control points of 24 to 53
/// bits, the points of the patches computed in doubles, turned in doubles and scaled by 25.4 or not: they
/// have a side in common, or one in four a corner.
Pair spline_neighbours(Generator& generator);

/// y begins on a part of a side of x, or on more than it, goes on smoothly there or not: a T-junction.
Pair parts_of_sides(Generator& generator);

/// y begins half-way along a side of x and ends with it.
Pair half_sides(Generator& generator);

/// y begins on a parameter line of x, or on more than that, and leaves x at some angle.
Pair sides_on_lines(Generator& generator);

/// x is a parallelogram with control points of up to 53 bits, and y begins on a segment in it.
Pair sheets_on_planes(Generator& generator);

/// One of the families, in this order.
inline constexpr std::array all = {spline_neighbours, parts_of_sides, half_sides, sides_on_lines,
                                   sheets_on_planes};

}  // namespace exsect::side_pairs
