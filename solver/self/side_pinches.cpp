#include "self/side_pinches.h"

#include <exsect/algebra/bernstein.h>

#include <array>

namespace exsect {
namespace {

using HomogeneousCurve4 = std::array<Polynomial, 4>;

/// Of the row, a combination of rows, of the net.
HomogeneousCurve4 curve_of(const std::vector<HomogeneousPoint>& row) {
  HomogeneousCurve4 curve;
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<Rational> coefficients;
    for (const HomogeneousPoint& p : row) coefficients.push_back(p[k]);
    curve[k] = from_bernstein(coefficients);
  }
  return curve;
}

/// The 2 by 2 minors are all 0 where this is.
Polynomial dependent(const HomogeneousCurve4& a, const HomogeneousCurve4& b) {
  Polynomial common;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) common = gcd(common, a[i] * b[j] - a[j] * b[i]);
  return common;
}

/// The same for three vectors.
Polynomial dependent(const HomogeneousCurve4& a, const HomogeneousCurve4& b, const HomogeneousCurve4& c) {
  Polynomial common;
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    const std::size_t i = left_out == 0 ? 1 : 0, j = left_out <= 1 ? 2 : 1, k = left_out == 3 ? 2 : 3;
    common = gcd(common, a[i] * (b[j] * c[k] - b[k] * c[j]) + a[j] * (b[k] * c[i] - b[i] * c[k]) +
                             a[k] * (b[i] * c[j] - b[j] * c[i]));
  }
  return common;
}

/// On the side where the first parameter is `value`; x_u and x_v are dependent where X, X_u and X_v are.
void append(std::vector<SidePinch>& found, const RationalPatch& patch, std::size_t fixed, int value) {
  std::vector<HomogeneousPoint> side, across;
  const int row = value == 0 ? 0 : patch.degree_u(), next = value == 0 ? 1 : row - 1;
  for (int j = 0; j <= patch.degree_v(); ++j) {
    side.push_back(patch.homogeneous(row, j));
    across.push_back(patch.homogeneous(next, j));
  }
  const HomogeneousCurve4 x = curve_of(side), y = curve_of(across);
  HomogeneousCurve4 along;
  for (std::size_t k = 0; k < 4; ++k) along[k] = x[k].derivative();
  const Polynomial common = dependent(x, y, along);
  if (common.is_zero()) return;
  const Polynomial resting = dependent(x, along);
  for (const RealAlgebraic& at : real_roots(common, 0, 1))
    found.push_back({fixed, value, at, sign_at(resting, at) == 0});
}

}  // namespace

std::vector<SidePinch> side_pinches(const RationalPatch& patch) {
  std::vector<SidePinch> found;
  for (const int value : {0, 1}) {
    append(found, patch, 0, value);
    append(found, patch.transposed(), 1, value);
  }
  return found;
}

bool contains(const ParameterRectangle& where, const SidePinch& pinch) {
  const RationalInterval& across = pinch.fixed == 0 ? where.u : where.v;
  const RationalInterval& along = pinch.fixed == 0 ? where.v : where.u;
  return across.lower <= pinch.value && across.upper >= pinch.value && pinch.at.compare(along.lower) >= 0 &&
         pinch.at.compare(along.upper) <= 0;
}

}  // namespace exsect
