// How many chords a piece of a curve is drawn with. Internal to solver/.
#pragma once

#include <algorithm>

namespace exsect {

/// Bounds the memory of a polyline, whatever its tolerance: its bound is then proved for these chords.
inline constexpr int kMostChords = 1 << 17;

/// `wanted`, but at least `least` and at most kMostChords. Requires 1 <= least <= kMostChords.
inline int chord_count(double wanted, double least = 1) {
  return wanted < kMostChords ? static_cast<int>(std::max(wanted, least)) : kMostChords;
}

}  // namespace exsect
