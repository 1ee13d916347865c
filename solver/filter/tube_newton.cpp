#include "filter/tube_newton.h"

#include <algorithm>
#include <cmath>

#include "filter/tube_columns.h"

namespace exsect::filter {

namespace {

/// x and its derivative in space, up to a factor: x_u = (X_u - x X_u4) / X_4.
Vec3 affine_derivative(const Vec<4>& p, const Vec<4>& d) {
  const Vec3 x = affine(p);
  return {(d[0] - x[0] * d[3]) / p[3], (d[1] - x[1] * d[3]) / p[3], (d[2] - x[2] * d[3]) / p[3]};
}

template <class K>
struct FirstOrder {
  Row<K> value;
  Row<K> first;
  Row<K> second;
};

/// A patch and its derivatives at (h,k), approximately.
template <class K>
FirstOrder<K> first_order_at(const PatchOf<K>& patch, double h, double k) {
  FirstOrder<K> at;
  at.value = value_at<K>(patch.power, h, k);
  derivatives<K>(patch.power, h, k, at.first, at.second);
  return at;
}

}  // namespace

template <class K>
Linearisation<K> linearise(const PairOf<K>& pair, const Unknowns<K>& w) {
  const CoefficientsOf<K> x = expand(pair.x, w[0], w[1]);
  const CoefficientsOf<K> y = expand(pair.y, w[2], w[3]);
  Linearisation<K> at;
  const auto tangent = [](const Vec3& xu, const Vec3& xv, const Vec3& yr, const Vec3& ys) {
    const Vec3 nx = cross(xu, xv);
    const Vec3 ny = cross(yr, ys);
    return Vec4{dot(xv, ny), -dot(xu, ny), -dot(ys, nx), dot(yr, nx)};
  };
  const Row<K>&xu = x[kFirst<K>], &xv = x[kSecond], &yr = y[kFirst<K>], &ys = y[kSecond];
  at.column = columns_of<K>(xu, xv, y[0], yr, ys, w);
  if constexpr (K::weighted) {
    const double scale = kScaleUnit * w[4];
    at.value = x[0] - scale * y[0];
    const Vec4 t = tangent(affine_derivative(x[0], xu), affine_derivative(x[0], xv),
                           affine_derivative(y[0], yr), affine_derivative(y[0], ys));
    const double weight_x = xu[3] * t[0] + xv[3] * t[1];
    const double weight_y = yr[3] * t[2] + ys[3] * t[3];
    at.tangent = {t[0], t[1], t[2], t[3], (weight_x - scale * weight_y) / (kScaleUnit * y[0][3])};
  } else {
    at.value = x[0] - y[0];
    at.tangent = tangent(xu, xv, yr, ys);
  }
  return at;
}

template <class K>
Unknowns<K> with_scale(const PairOf<K>& pair, const Vec4& place) {
  Unknowns<K> result{};
  std::copy(place.begin(), place.end(), result.begin());
  if constexpr (K::weighted) {
    const double x = value_at<K>(pair.x.power, place[0], place[1])[3];
    const double y = value_at<K>(pair.y.power, place[2], place[3])[3];
    result[4] = std::clamp(x / (kScaleUnit * y), kLeastScale, 1.0);
  }
  return result;
}

std::size_t steepest(const Vec4& tangent, const Vec4& weight) {
  std::size_t axis = 0;
  for (std::size_t j = 1; j < 4; ++j) {
    if (std::fabs(tangent[j]) * weight[axis] > std::fabs(tangent[axis]) * weight[j]) {
      axis = j;
    }
  }
  return axis;
}

template <class K>
bool improve(const PairOf<K>& pair, Unknowns<K>& point, std::size_t axis, int steps) {
  const auto& others = kOthers<K>[axis];
  for (int step = 0; step < steps; ++step) {
    const FirstOrder<K> x = first_order_at(pair.x, point[0], point[1]);
    const FirstOrder<K> y = first_order_at(pair.y, point[2], point[3]);
    std::array<Row<K>, K::rows> c;
    if (!invert_others<K>(columns_of<K>(x.first, x.second, y.value, y.first, y.second, point), axis, c)) {
      return false;
    }
    Row<K> value;
    if constexpr (K::weighted) {
      value = x.value - (kScaleUnit * point[4]) * y.value;
    } else {
      value = x.value - y.value;
    }
    const Row<K> correction = product(c, value);
    for (std::size_t row = 0; row < K::rows; ++row) {
      point[others[row]] -= correction[row];
    }
    if (!within_reach<K>(point)) {
      return false;
    }
    if (largest(correction) < 0x1p-16) {
      break;
    }
  }
  return true;
}

#define EXSECT_INSTANTIATE(K)                                                   \
  template Unknowns<K> with_scale<K>(const PairOf<K>&, const Vec4&);            \
  template Linearisation<K> linearise<K>(const PairOf<K>&, const Unknowns<K>&); \
  template bool improve<K>(const PairOf<K>&, Unknowns<K>&, std::size_t, int);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
