// Points where a curve of the intersection meets sides of both patches at once, or a corner. Internal to
// solver/; docs/method-doubles.md, section 14.12.
#pragma once

#include "filter/exact_patch.h"
#include "filter/part.h"
#include "filter/tube.h"

namespace exsect::filter {

/// A solution with two parameters or more at sides, exactly: on[j] is 1/2 or -1/2 for these, as
/// ball.middle[j], and 0 for the others. All solutions in the tube's region are on its arc, in the interior
/// of the intervals of the other parameters. Of the arc the domain contains this point and, if it `enters`,
/// the part on one side of the point, where no parameter is at a side; on[leaving] != 0, and if it enters
/// w'_leaving != 0. On that part, w_j is strictly monotone if rate[j] is not 0, and then it has the sign of
/// dw_j/dw_axis.
template <class K>
struct SidePointOf {
  BallOf<K> ball;
  Vec4 on;
  TubeOf<K> tube;
  bool enters;
  std::size_t leaving;
  std::array<bool, 4> still;  // w_j' = 0 in the point, exactly
  std::array<int, 4> rate = {};
};

/// The one near a place (centred), with one parameter at a side, if it can be proved. Empty for biquadratic
/// pairs, behind which there is exact arithmetic.
template <class K>
std::optional<SidePointOf<K>> side_point_near(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                              const PairOf<K>& pair, const Vec4& place);

/// All solutions on the two parts are in the tube's region.
template <class K>
bool lies_in_region(const SidePointOf<K>& point, const Part& x, const Part& y);

}  // namespace exsect::filter
