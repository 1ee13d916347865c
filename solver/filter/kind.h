// What the solution in doubles is a template of: the bidegree of both patches, and the number of equations.
// Internal to solver/; docs/method-doubles.md, section 14.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace exsect::filter {

/// Pairs of patches of bidegree (Degree,Degree), those of lower degrees being elevated, exactly. Rows: 3
/// coordinates, or 4 homogeneous ones of weighted patches; then the scale between them is a fifth unknown.
template <std::size_t Degree, std::size_t Rows>
struct Kind {
  static constexpr std::size_t degree = Degree;
  static constexpr std::size_t rows = Rows;
  static constexpr bool weighted = Rows == 4;
  static constexpr std::size_t unknowns = Rows + 1;  // u, v, r, s, and the scale (14.30)
  static constexpr std::size_t side = Degree + 1;    // control points along a side
  static constexpr std::size_t count = side * side;
  static constexpr int width = Rows > 3 ? 2 : Degree > 2 ? 1 : 0;  // see error_bounds.h
  static constexpr std::size_t orders = 2 * Degree + 1;            // 0 to the greatest total degree
};
using Biquadratic = Kind<2, 3>;
using Bicubic = Kind<3, 3>;
using WeightedBiquadratic = Kind<2, 4>;
using WeightedBicubic = Kind<3, 4>;

/// Explicit instantiations, at the end of a source.
#define EXSECT_FILTER_POLYNOMIAL_KINDS(INSTANTIATE) INSTANTIATE(Biquadratic) INSTANTIATE(Bicubic)
#define EXSECT_FILTER_KINDS(INSTANTIATE)      \
  EXSECT_FILTER_POLYNOMIAL_KINDS(INSTANTIATE) \
  INSTANTIATE(WeightedBiquadratic) INSTANTIATE(WeightedBicubic)

template <std::size_t N>
using Vec = std::array<double, N>;
using Vec3 = Vec<3>;
/// Parameters (u,v,r,s), each minus 1/2: the domain is [-1/2,1/2]^4.
using Vec4 = Vec<4>;

template <class K>
using Row = Vec<K::rows>;
template <class K>
using Unknowns = Vec<K::unknowns>;
/// Coefficients of a vector polynomial, that of h^i k^j at index side i + j.
template <class K>
using CoefficientsOf = std::array<Row<K>, K::count>;
using Coefficients = CoefficientsOf<Biquadratic>;
/// Indices of the coefficients of h and k.
template <class K>
inline constexpr std::size_t kFirst = K::side;
inline constexpr std::size_t kSecond = 1;

template <std::size_t N>
Vec<N> operator+(const Vec<N>& a, const Vec<N>& b) {
  static_assert(N == 3 || N == 4);
  if constexpr (N == 3) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  } else {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
  }
}
template <std::size_t N>
Vec<N> operator-(const Vec<N>& a, const Vec<N>& b) {
  static_assert(N == 3 || N == 4);
  if constexpr (N == 3) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  } else {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
  }
}
template <std::size_t N>
Vec<N> operator*(double t, const Vec<N>& a) {
  static_assert(N == 3 || N == 4);
  if constexpr (N == 3) {
    return {t * a[0], t * a[1], t * a[2]};
  } else {
    return {t * a[0], t * a[1], t * a[2], t * a[3]};
  }
}
template <std::size_t N>
double dot(const Vec<N>& a, const Vec<N>& b) {
  static_assert(N == 3 || N == 4);
  const double sum = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  if constexpr (N == 3) {
    return sum;
  } else {
    return sum + a[3] * b[3];
  }
}
template <std::size_t N>
double largest(const Vec<N>& a) {
  static_assert(N == 3 || N == 4);
  // Nonnegative doubles are ordered as the integers with their bits are, and NaN is above infinity.
  const auto bits = [](double size) { return std::bit_cast<std::int64_t>(std::fabs(size)); };
  std::int64_t most = std::max({bits(a[0]), bits(a[1]), bits(a[2])});
  if constexpr (N == 4) most = std::max(most, bits(a[3]));
  return std::bit_cast<double>(most);
}
/// |a_0| + |a_1| + ...
template <std::size_t N>
double size1(const Vec<N>& a) {
  static_assert(N == 3 || N == 4);
  const double sum = std::fabs(a[0]) + std::fabs(a[1]) + std::fabs(a[2]);
  if constexpr (N == 3) {
    return sum;
  } else {
    return sum + std::fabs(a[3]);
  }
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// a ^ b: the cross product, or coordinates 01, 02, 03, 12, 13, 23 in R^4.
inline Vec3 wedge(const Vec3& a, const Vec3& b) { return cross(a, b); }
inline Vec<6> wedge(const Vec4& a, const Vec4& b) {
  const auto minor = [&](std::size_t i, std::size_t j) { return a[i] * b[j] - a[j] * b[i]; };
  return {minor(0, 1), minor(0, 2), minor(0, 3), minor(1, 2), minor(1, 3), minor(2, 3)};
}
/// The covector x -> det(x, a, p, q), b = p ^ q.
inline Vec4 join(const Vec4& a, const Vec<6>& b) {
  return {a[1] * b[5] - a[2] * b[4] + a[3] * b[3], a[2] * b[2] - a[0] * b[5] - a[3] * b[1],
          a[0] * b[4] - a[1] * b[2] + a[3] * b[0], a[1] * b[1] - a[0] * b[3] - a[2] * b[0]};
}

/// The point of space.
inline Vec3 affine(const Vec3& p) { return p; }
inline Vec3 affine(const Vec4& p) { return {p[0] / p[3], p[1] / p[3], p[2] / p[3]}; }

}  // namespace exsect::filter
