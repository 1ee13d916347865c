// Polynomials in x, y, z in the tensor Bernstein basis of a box, exact. Internal to solver/.
#pragma once

#include <exsect/geometry/space_polynomial.h>
#include <exsect/implicit/space_curve_surfaces.h>

#include <array>
#include <utility>
#include <vector>

namespace exsect {

/// f on a box; on it f lies between the least and the greatest coefficient.
class SpaceBernstein {
 public:
  /// All sides must have positive length.
  SpaceBernstein(const SpacePolynomial& f, const SpaceBox& box);

  RationalInterval range() const;
  /// +1 if all coefficients are positive, -1 if all are negative, else 0.
  int sign() const;
  /// The lower and the upper half along an axis.
  std::pair<SpaceBernstein, SpaceBernstein> split(std::size_t axis) const;

 private:
  SpaceBernstein() = default;

  std::array<std::size_t, 3> size_;    // degrees + 1
  std::vector<Integer> coefficients_;  // [i][j][k], k fastest
  Integer denominator_;
};

}  // namespace exsect
