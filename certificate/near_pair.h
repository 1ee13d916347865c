// A pair of patches in doubles, for the search for claims.
#pragma once

#include "certificate/patches.h"

namespace exsect::cli {

using Map = checker::Map<double>;

/// x and y translated, their coordinates and weights divided by powers of two, so that F is divided by
/// `scale`, and rounded to doubles.
struct NearPair {
  Map power;                  // F
  std::array<Map, 2> charts;  // H of x, and of x with exchanged parameters; of one patch
  std::array<checker::WeightedNet<double>, 2> control;  // of x and y
  double scale;
};
NearPair near_pair(const Patches& patches);

}  // namespace exsect::cli
