// Pairs cut so that a solution inside comes to lie on sides or in corners.
#pragma once

#include <vector>

#include "support/height_pairs.h"

namespace exsect::testing {

/// Parts of a pair, with its centre on this many sides.
struct Cut {
  const char* name;
  RationalPatch x;
  RationalPatch y;
  std::size_t sides;
};
inline std::vector<Cut> cuts(const height_pairs::Heights& pair) {
  const auto& [a, b, r, s] = pair.centre;
  const RationalPatch corner_of_x = pair.x.restricted_to(a, 1, b, 1);
  return {{"lower side of x", pair.x.restricted_to(a, 1, 0, 1), pair.y, 1},
          {"upper side of x", pair.x.restricted_to(0, 1, 0, b), pair.y, 1},
          {"side of y", pair.x, pair.y.restricted_to(0, 1, 0, s), 1},
          {"corner of x", corner_of_x, pair.y, 2},
          {"corner of y", pair.x, pair.y.restricted_to(0, r, s, 1), 2},
          {"sides of both", pair.x.restricted_to(0, 1, b, 1), pair.y.restricted_to(r, 1, 0, 1), 2},
          {"corner of x and side of y", corner_of_x, pair.y.restricted_to(r, 1, 0, 1), 3},
          {"corners of both", corner_of_x, pair.y.restricted_to(r, 1, s, 1), 4}};
}

}  // namespace exsect::testing
