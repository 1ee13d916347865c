// The segment v = 1/3, s = 1/2 of two planes, with both ends on sides of both.
#pragma once

#include "filter/exact_patch.h"
#include "filter/patch.h"
#include "support/known_curves.h"

namespace exsect::testing {

/// (u, v, 0) and (r, 1/3, s - 1/2): u = r.
struct Segment {
  using K = filter::Bicubic;
  filter::ElevatedPatch<K> x = filter::elevated<K>(plane_patch());
  filter::ElevatedPatch<K> y = filter::elevated<K>(plane({0, q(1, 3), q(-1, 2)}, {1, 0, 0}, {0, 0, 1}));
  filter::PairOf<K> pair = filter::make_pair_of<K>(x, y).value();
};

/// Next to its end u = r = 1, centred.
inline constexpr filter::Vec4 kNearTheEnd = {0.5, -0.166, 0.5, 0.001};

}  // namespace exsect::testing
