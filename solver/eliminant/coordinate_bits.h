// The length of the numbers of a pair. Internal to solver/.
#pragma once

#include <exsect/algebra/rational.h>

#include <algorithm>
#include <cstddef>

namespace exsect {

/// The bits of the largest number in each coordinate, summed over the coordinates, of an IntegerPair or a
/// WeightedPair: an eliminant of degree d in each coordinate has about d times as many.
template <class Pair>
std::size_t coordinate_bits(const Pair& pair) {
  std::size_t bits = 0;
  for (std::size_t k = 0; k < pair.x[0][0].size(); ++k) {
    Integer largest = 1;
    for (const auto* net : {&pair.x, &pair.y})
      for (const auto& row : *net)
        for (const auto& c : row) largest = std::max(largest, Integer(abs(c[k])));
    bits += msb(largest) + 1;
  }
  return bits;
}

}  // namespace exsect
