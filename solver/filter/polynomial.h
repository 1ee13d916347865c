// Vector polynomials in two variables by their coefficients, and bounds of their derivatives near zero. Loops
// are unrolled for the compiler: the degree is a constant. Internal to solver/; docs/method-doubles.md,
// section 14.2.
#pragma once

#include <exsect/algebra/rounding_bounds.h>

#include <utility>

#include "filter/patch.h"

namespace exsect::filter {

/// For the bodies of unrolled loops, which compilers would leave out of line.
#define EXSECT_INLINE __attribute__((always_inline))

/// Calls visit(i), i a compile-time constant, for 0 <= i < Count.
template <std::size_t Count, class Visit>
[[gnu::always_inline]] inline void for_each_index(const Visit& visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) EXSECT_INLINE {
    (visit(std::integral_constant<std::size_t, I>{}), ...);
  }
  (std::make_index_sequence<Count>{});
}

/// 1, t, t², ..., t^Degree.
template <class K>
[[gnu::always_inline]] inline Vec<K::side> powers(double t) {
  Vec<K::side> p;
  p[0] = 1;
  for_each_index<K::degree>([&](auto i) EXSECT_INLINE { p[i + 1] = i == 0 ? t : p[i] * t; });
  return p;
}

/// p(a,b)
template <class K>
Row<K> value_at(const CoefficientsOf<K>& c, double a, double b) {
  constexpr std::size_t n = K::degree;
  Row<K> result;
  for_each_index<K::rows>([&](auto row) EXSECT_INLINE {
    double sum = 0;
    for_each_index<K::side>([&](auto up) EXSECT_INLINE {
      constexpr std::size_t i = n - up;
      double inner = c[K::side * i + n][row];
      for_each_index<n>([&](auto down)
                            EXSECT_INLINE { inner = c[K::side * i + n - 1 - down][row] + b * inner; });
      sum = up == 0 ? inner : inner + a * sum;
    });
    result[row] = sum;
  });
  return result;
}

/// Coefficient of tau^order of p(tau a, tau b), given the powers of a and b.
template <class K, std::size_t Order>
[[gnu::always_inline]] inline Row<K> form_of_order(const CoefficientsOf<K>& c, const Vec<K::side>& a,
                                                   const Vec<K::side>& b) {
  constexpr std::size_t first = Order > K::degree ? Order - K::degree : 0;
  constexpr std::size_t last = Order < K::degree ? Order : K::degree;
  constexpr std::size_t count = last - first + 1;
  Row<K> sum{};
  for_each_index<count>([&](auto step) EXSECT_INLINE {
    constexpr std::size_t i = last - step;
    constexpr std::size_t j = Order - i;
    const Row<K>& term = c[K::side * i + j];
    const double weight = i == 0 ? b[j] : j == 0 ? a[i] : a[i] * b[j];
    sum = step == 0 ? weight * term : sum + weight * term;
  });
  return sum;
}

/// Sums of |c_ij| times weights, row by row; those that are 0 as compile-time constants do not count.
/// Bounds of |p_a(a,b) - p_a(0,0)|, |p_b(a,b) - p_b(0,0)| over |a| <= ha, |b| <= hb.
template <class K>
struct Variation {
  Row<K> first;
  Row<K> second;
};
template <class K>
[[gnu::always_inline]] inline Variation<K> variation(const CoefficientsOf<K>& c, double ha, double hb) {
  const Vec<K::side> a = powers<K>(ha);
  const Vec<K::side> b = powers<K>(hb);
  Variation<K> v{};
  for_each_index<K::count>([&](auto k) EXSECT_INLINE {
    constexpr std::size_t i = k / K::side;
    constexpr std::size_t j = k % K::side;
    if constexpr (i + j >= 2) {
      [[maybe_unused]] double to_first = 0;
      [[maybe_unused]] double to_second = 0;
      if constexpr (i > 0) to_first = static_cast<double>(i) * (a[i - 1] * b[j]);
      if constexpr (j > 0) to_second = static_cast<double>(j) * (a[i] * b[j - 1]);
      for_each_index<K::rows>([&](auto row) EXSECT_INLINE {
        const double size = std::fabs(c[k][row]);
        if constexpr (i > 0) v.first[row] += size * to_first;
        if constexpr (j > 0) v.second[row] += size * to_second;
      });
    }
  });
  return v;
}

/// Bounds of |p(a,b) - p(0,0)| over |a| <= ha, |b| <= hb.
template <class K>
Row<K> value_variation(const CoefficientsOf<K>& c, double ha, double hb) {
  const Vec<K::side> a = powers<K>(ha);
  const Vec<K::side> b = powers<K>(hb);
  Row<K> sum{};
  for (std::size_t k = 1; k < K::count; ++k) {
    for (std::size_t row = 0; row < K::rows; ++row) {
      sum[row] += std::fabs(c[k][row]) * (a[k / K::side] * b[k % K::side]);
    }
  }
  return sum;
}

/// p_a and p_b at (a,b).
template <class K>
[[gnu::always_inline]] inline void derivatives(const CoefficientsOf<K>& c, double a, double b, Row<K>& first,
                                               Row<K>& second) {
  constexpr std::size_t n = K::degree;
  for_each_index<K::rows>([&](auto row) EXSECT_INLINE {
    Vec<K::side> value;  // of the coefficients of a^i at b
    Vec<K::side> slope;
    for_each_index<K::side>([&](auto i) EXSECT_INLINE {
      double p = c[K::side * i + n][row];
      double d = p;
      for_each_index<n>([&](auto down) EXSECT_INLINE {
        constexpr std::size_t j = n - 1 - down;
        p = c[K::side * i + j][row] + b * p;
        if constexpr (j > 0) d = p + b * d;
      });
      value[i] = p;
      slope[i] = d;
    });
    double p = value[n];
    double d = p;
    double s = slope[n];
    for_each_index<n>([&](auto down) EXSECT_INLINE {
      constexpr std::size_t i = n - 1 - down;
      p = value[i] + a * p;
      if constexpr (i > 0) d = p + a * d;
      s = slope[i] + a * s;
    });
    first[row] = d;
    second[row] = s;
  });
}

/// Bound, over all rows, of |p_aa| + |p_ab|, |p_ab| + |p_bb| over |a| <= ha, |b| <= hb.
template <class K>
double second_derivatives(const CoefficientsOf<K>& c, double ha, double hb) {
  const Vec<K::side> a = powers<K>(ha);
  const Vec<K::side> b = powers<K>(hb);
  double result = 0;
  for (std::size_t row = 0; row < K::rows; ++row) {
    double aa = 0;
    double ab = 0;
    double bb = 0;
    for_each_index<K::count>([&](auto k) EXSECT_INLINE {
      constexpr std::size_t i = k / K::side;
      constexpr std::size_t j = k % K::side;
      const double size = std::fabs(c[k][row]);
      if constexpr (i > 1) aa += static_cast<double>(i * (i - 1)) * (size * (a[i - 2] * b[j]));
      if constexpr (i > 0 && j > 0) ab += static_cast<double>(i * j) * (size * (a[i - 1] * b[j - 1]));
      if constexpr (j > 1) bb += static_cast<double>(j * (j - 1)) * (size * (a[i] * b[j - 2]));
    });
    result = larger_bound(result, ab + larger_bound(aa, bb));
  }
  return result;
}

/// |p''(w)[w',w'] - p''(0)[d,d]| for |w_0| <= h[0], |w_1| <= h[1], w' in d +- delta; p has the magnitudes of
/// coefficients c, the errors of which are left out.
template <class K>
Row<K> quadratic_deviation(const CoefficientsOf<K>& c, const double* d, const double* delta,
                           const double* h) {
  const double a0 = std::fabs(d[0]) + delta[0];
  const double a1 = std::fabs(d[1]) + delta[1];
  const double d0 = std::fabs(d[0]);
  const double d1 = std::fabs(d[1]);
  const double aa = a0 * a0;
  const double ab = a0 * a1;
  const double bb = a1 * a1;
  const Vec<K::side> h0 = powers<K>(h[0]);
  const Vec<K::side> h1 = powers<K>(h[1]);
  Row<K> sum{};
  for_each_index<K::count>([&](auto k) EXSECT_INLINE {
    constexpr std::size_t i = k / K::side;
    constexpr std::size_t j = k % K::side;
    if constexpr (i + j >= 2) {
      double weight = 0;
      if constexpr (i == 2 && j == 0) {
        weight = 2 * delta[0] * (a0 + d0);
      } else if constexpr (i == 1 && j == 1) {
        weight = 2 * (delta[0] * d1 + a0 * delta[1]);
      } else if constexpr (i == 0 && j == 2) {
        weight = 2 * delta[1] * (a1 + d1);
      } else {
        if constexpr (i > 1) weight += static_cast<double>(i * (i - 1)) * (h0[i - 2] * h1[j] * aa);
        if constexpr (i > 0 && j > 0) weight += static_cast<double>(2 * i * j) * (h0[i - 1] * h1[j - 1] * ab);
        if constexpr (j > 1) weight += static_cast<double>(j * (j - 1)) * (h0[i] * h1[j - 2] * bb);
      }
      for_each_index<K::rows>([&](auto row) EXSECT_INLINE { sum[row] += weight * std::fabs(c[k][row]); });
    }
  });
  return sum;
}

/// e_0 + e_1 t + e_2 t² + ...
template <std::size_t N>
double power_sum(const std::array<double, N>& e, double t) {
  double sum = e[N - 1];
  for_each_index<N - 1>([&](auto down) EXSECT_INLINE { sum = e[N - 2 - down] + t * sum; });
  return sum;
}

/// e_1 + 2 e_2 t + ...: the coefficient of a^i b^j appears in derivatives max(i,j) times at most.
template <std::size_t N>
double derivative_power_sum(const std::array<double, N>& e, double t) {
  double sum = static_cast<double>(N - 1) * e[N - 1];
  for_each_index<N - 2>([&](auto down) EXSECT_INLINE {
    constexpr std::size_t i = N - 2 - down;
    sum = static_cast<double>(i) * e[i] + t * sum;
  });
  return sum;
}

}  // namespace exsect::filter
