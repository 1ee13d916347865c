// Products of vectors over any commutative ring: Q, polynomials, number fields, balls, doubles.
#pragma once

#include <array>
#include <cstddef>

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

template <class Ring>
Ring determinant_over(const VectorOver<Ring>& a, const VectorOver<Ring>& b, const VectorOver<Ring>& c) {
  return dot_over(a, cross_over(b, c));
}

/// Of four vectors with four coordinates, by two of them at a time.
template <class Ring>
Ring determinant_over(const std::array<Ring, 4>& a, const std::array<Ring, 4>& b,
                      const std::array<Ring, 4>& c, const std::array<Ring, 4>& d) {
  const auto minor = [](const auto& p, const auto& q, std::size_t i, std::size_t j) -> Ring {
    return p[i] * q[j] - p[j] * q[i];
  };
  return minor(a, b, 0, 1) * minor(c, d, 2, 3) - minor(a, b, 0, 2) * minor(c, d, 1, 3) +
         minor(a, b, 0, 3) * minor(c, d, 1, 2) + minor(a, b, 1, 2) * minor(c, d, 0, 3) -
         minor(a, b, 1, 3) * minor(c, d, 0, 2) + minor(a, b, 2, 3) * minor(c, d, 0, 1);
}

}  // namespace exsect
