#include "filter/mean_derivatives.h"

#include <cmath>

namespace exsect::filter {

namespace {

double size(const Vec3& row, const Vec3& v) { return std::fabs(dot(row, v)); }

}  // namespace

std::optional<RectangleExpansion> expand(const Patch& patch, const Rectangle& where) {
  std::array<double, 2> middle;
  std::array<double, 2> half;
  for (std::size_t i = 0; i < 2; ++i) {
    middle[i] = 0.5 * (where.lower[i] + where.upper[i]);
    half[i] = kSlack * (0.5 * (where.upper[i] - where.lower[i]) + kSumRounding);
    if (!(std::fabs(middle[i]) + half[i] <= kReach)) {
      return std::nullopt;
    }
  }
  return RectangleExpansion{expand(patch, middle[0], middle[1]), half};
}

MeanDerivative mean_first(const RectangleExpansion& x, const Vec3& row) {
  const Coefficients& c = x.at_middle;
  const auto [h, k] = x.half;
  return {dot(row, c[3]), 2 * size(row, c[6]) * h + size(row, c[4]) * k + 2 * size(row, c[7]) * h * k +
                              size(row, c[5]) * k * k + 2 * size(row, c[8]) * h * k * k};
}

MeanDerivative mean_second(const RectangleExpansion& x, const Vec3& row) {
  const Coefficients& c = x.at_middle;
  const auto [h, k] = x.half;
  return {dot(row, c[1]), 2 * size(row, c[2]) * k + size(row, c[4]) * h + 2 * size(row, c[5]) * h * k +
                              size(row, c[7]) * h * h + 2 * size(row, c[8]) * h * h * k};
}

}  // namespace exsect::filter
