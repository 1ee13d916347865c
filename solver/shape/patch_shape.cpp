#include "shape/patch_shape.h"

#include <algorithm>
#include <array>

namespace exsect {

namespace {

/// x_u x x_v = 0 for all (u,v): all coefficients of the product of the power bases.
bool has_no_normal(const ControlNet& c) {
  std::array<std::array<Point, 4>, 4> product{};
  for (std::size_t i = 1; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t l = 0; l < 3; ++l)
        for (std::size_t m = 1; m < 3; ++m) {
          Point& sum = product[i + l - 1][j + m - 1];
          sum = sum + Rational(i * m) * cross(c[i][j], c[l][m]);
        }
  return std::all_of(product.begin(), product.end(),
                     [](const auto& row) { return std::all_of(row.begin(), row.end(), is_zero); });
}

}  // namespace

PatchShape shape(const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  bool of_first = true;
  bool of_second = true;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      if (is_zero(c[i][j])) continue;
      of_first = of_first && j == 0;
      of_second = of_second && i == 0;
    }
  if (of_first && of_second) return PatchShape::point;
  if (of_first) return PatchShape::curve_of_first;
  if (of_second) return PatchShape::curve_of_second;
  return has_no_normal(c) ? PatchShape::curve : PatchShape::surface;
}

}  // namespace exsect
