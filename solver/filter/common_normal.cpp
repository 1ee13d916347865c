#include "filter/common_normal.h"

#include <exsect/algebra/double_matrix.h>

#include <algorithm>
#include <cmath>

namespace exsect::filter {

namespace {

constexpr int kMostSteps = 12;
constexpr double kSettled = 0x1p-44;

}  // namespace

template <class K>
SecondOrder second_order(const PatchOf<K>& patch, double h, double k) {
  return in_space<K>(expand(patch, h, k));
}

template <class K>
std::optional<CommonNormal> common_normal(const PairOf<K>& pair, Vec4 w) {
  for (int step = 0; step < kMostSteps; ++step) {
    const SecondOrder x = second_order(pair.x, w[0], w[1]);
    const SecondOrder y = second_order(pair.y, w[2], w[3]);
    const auto equations = common_normal_equations<double>(x, y);
    DoubleMatrix matrix(4, 4);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) matrix(i, j) = equations.jacobian[i][j];
    const std::vector<double> change = solution(matrix, {equations.value.begin(), equations.value.end()});
    double size = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      w[j] -= change[j];
      if (!(std::fabs(w[j]) < 0.75)) {
        return std::nullopt;
      }
      size = std::max(size, std::fabs(change[j]));
    }
    if (size < kSettled) {
      const Vec3 gap = second_order(pair.x, w[0], w[1]).value - second_order(pair.y, w[2], w[3]).value;
      return CommonNormal{w, largest(gap)};
    }
  }
  return std::nullopt;
}

template <class K>
bool looks_like_crossing(const PairOf<K>& pair, const Vec4& w) {
  const SecondOrder x = second_order(pair.x, w[0], w[1]);
  const SecondOrder y = second_order(pair.y, w[2], w[3]);
  const Vec3 n = cross(y.u, y.v);
  const Vec3 along_u = cross(y.v, n);
  const Vec3 along_v = cross(n, y.u);
  const double square = dot(n, n);
  const auto in_plane = [&](const Vec3& d) {
    return std::array{dot(along_u, d) / square, dot(along_v, d) / square};
  };
  const auto a = in_plane(x.u);
  const auto b = in_plane(x.v);
  // Of y above the plane, the polar form of order two.
  const auto height = [&](const std::array<double, 2>& p, const std::array<double, 2>& q) {
    return dot(n, (2 * p[0] * q[0]) * y.uu + (p[0] * q[1] + p[1] * q[0]) * y.uv + (2 * p[1] * q[1]) * y.vv);
  };
  const double uu = dot(n, x.uu) - 0.5 * height(a, a);
  const double uv = dot(n, x.uv) - height(a, b);
  const double vv = dot(n, x.vv) - 0.5 * height(b, b);
  return uv * uv > 4 * uu * vv;
}

#define EXSECT_INSTANTIATE(K)                                                    \
  template SecondOrder second_order<K>(const PatchOf<K>&, double, double);       \
  template std::optional<CommonNormal> common_normal<K>(const PairOf<K>&, Vec4); \
  template bool looks_like_crossing<K>(const PairOf<K>&, const Vec4&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
