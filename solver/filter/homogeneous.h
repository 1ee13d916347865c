// Exact homogeneous coordinates of the patches of a pair. Internal to solver/.
#pragma once

#include <exsect/geometry/vector_algebra.h>

#include <array>
#include <tuple>

#include "filter/exact_patch.h"

namespace exsect::filter {

template <class K>
HomogeneousPoint homogeneous(const ExactPatch<K>& patch, std::size_t i) {
  const Point& p = control_point(patch, i);
  return {p[0], p[1], p[2], patch.weights[i]};
}

inline HomogeneousPoint combined(const Rational& s, const HomogeneousPoint& a, const Rational& t,
                                 const HomogeneousPoint& b) {
  return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2], s * a[3] + t * b[3]};
}

/// 1/n of the derivative, and the value, of a curve of degree n.
template <std::size_t Count>
std::array<HomogeneousPoint, 2> tangent_and_value(std::array<HomogeneousPoint, Count> p, const Rational& t) {
  const Rational s = 1 - t;
  for (std::size_t level = 1; level + 1 < Count; ++level) {
    for (std::size_t i = 0; i + level < Count; ++i) p[i] = combined(s, p[i], t, p[i + 1]);
  }
  return {combined(1, p[1], -1, p[0]), combined(s, p[0], t, p[1])};
}

/// The value of a patch, and its derivatives up to a positive factor.
template <class K>
struct FirstOrder {
  HomogeneousPoint value;
  std::array<HomogeneousPoint, 2> derivative;

  FirstOrder(const ExactPatch<K>& patch, const Rational& u, const Rational& v) {
    std::array<HomogeneousPoint, K::side> values;
    std::array<HomogeneousPoint, K::side> tangents;
    for (std::size_t i = 0; i < K::side; ++i) {
      std::array<HomogeneousPoint, K::side> row;
      for (std::size_t j = 0; j < K::side; ++j) row[j] = homogeneous<K>(patch, K::side * i + j);
      std::tie(tangents[i], values[i]) = std::tuple_cat(tangent_and_value(row, v));
    }
    std::tie(derivative[0], value) = std::tuple_cat(tangent_and_value(values, u));
    derivative[1] = tangent_and_value(tangents, u)[1];
  }
};

inline Rational minor(const HomogeneousPoint& a, const HomogeneousPoint& b, std::size_t i, std::size_t j) {
  return a[i] * b[j] - a[j] * b[i];
}
inline Rational determinant(const HomogeneousPoint& a, const HomogeneousPoint& b, const HomogeneousPoint& c,
                            const HomogeneousPoint& d) {
  return determinant_over(a, b, c, d);
}

inline bool is_same_point(const HomogeneousPoint& a, const HomogeneousPoint& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (minor(a, b, k, 3) != 0) return false;
  }
  return true;
}

}  // namespace exsect::filter
