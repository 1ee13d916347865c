// The pairs of patches the benchmarks of this layer run on.
#pragma once

#include <exsect/geometry/patch_file.h>

namespace exsect {

struct Pair {
  BezierPatch x;
  BezierPatch y;
};

inline Pair first_example() {
  const PatchFile file = read_patches(EXSECT_EXAMPLES "/chapter9-first.json");
  return {file.patches[0].patch, file.patches[1].patch};
}

/// The first example rounded to binary64 coordinates.
inline Pair first_example_in_doubles() {
  const auto rounded = [](const BezierPatch& patch) {
    ControlNet net = patch.net();
    for (auto& row : net)
      for (Point& p : row)
        for (Rational& c : p) c = from_double(to_double(c));
    return BezierPatch(net);
  };
  const Pair pair = first_example();
  return {rounded(pair.x), rounded(pair.y)};
}

}  // namespace exsect
