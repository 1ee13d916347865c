// Patches from their coordinates as polynomials of the parameters.
#pragma once

#include <exsect/algebra/tensor_bernstein.h>
#include <exsect/geometry/rational_patch.h>

#include <algorithm>
#include <array>

namespace exsect::testing {

/// Of the least bidegree, at least (1,1).
inline RationalPatch patch_of(const std::array<BivariatePolynomial, 3>& x) {
  int m = 1, n = 1;
  for (const BivariatePolynomial& f : x) {
    m = std::max(m, f.degree_r());
    n = std::max(n, f.degree_s());
  }
  std::vector<std::vector<Point>> net(static_cast<std::size_t>(m) + 1,
                                      std::vector<Point>(static_cast<std::size_t>(n) + 1));
  for (std::size_t k = 0; k < 3; ++k) {
    const auto b = tensor_bernstein(x[k], m, n);
    for (std::size_t i = 0; i < net.size(); ++i)
      for (std::size_t j = 0; j < net[i].size(); ++j) net[i][j][k] = b[i][j];
  }
  return RationalPatch(net);
}

}  // namespace exsect::testing
