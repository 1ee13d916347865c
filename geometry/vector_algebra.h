// Products of 3-vectors over any commutative ring: Q, Z and Q[u]. Internal to geometry/.
#pragma once

#include <array>

namespace exsect {

template <class Ring>
using VectorOver = std::array<Ring, 3>;

template <class Ring>
Ring dot_over(const VectorOver<Ring>& a, const VectorOver<Ring>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Ring>
VectorOver<Ring> cross_over(const VectorOver<Ring>& a, const VectorOver<Ring>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace exsect
