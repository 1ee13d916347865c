#include "curve/mahler_measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace exsect {

namespace {

// On [1/2,1]: 2m - 2 <= log2 m <= 2m - 2 + 0.08608, a chord of a concave function and its largest distance,
// at m = 1/(2 ln 2). The slack covers the rounding of 2m - 2 and of the sum with an exponent below 2^32.
constexpr double largest_distance = 0.08608;
constexpr double rounding = 1e-6;

}  // namespace

ScaledDouble scaled_double(const Integer& a) {
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, a.backend().data());
  return {mantissa, exponent};
}

double log2_upper(double x) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return exponent + 2 * mantissa - 2 + largest_distance + rounding;
}

double log2_upper(const Integer& a) {
  const ScaledDouble s = scaled_double(a);
  return static_cast<double>(s.exponent) + 2 * std::abs(s.mantissa) - 2 + largest_distance + rounding;
}

double log2_lower(const Integer& a) {
  const ScaledDouble s = scaled_double(a);
  return static_cast<double>(s.exponent) + 2 * std::abs(s.mantissa) - 2 - rounding;
}

// |f_j| <= binom(n,j) 2^m(f) for each j, and Graeffe's f(t) f(-t), a polynomial in t^2, has twice the
// measure.
std::optional<double> measure_lower(std::vector<Integer> f) {
  while (!f.empty() && f.back() == 0) f.pop_back();
  if (f.empty()) return std::nullopt;
  constexpr int graeffe_steps = 3;
  const std::size_t n = f.size() - 1;
  for (int step = 0; step < graeffe_steps; ++step) {
    std::vector<Integer> even(n + 1);  // coefficients of f(t) f(-t)
    for (std::size_t i = 0; i <= n; ++i)
      for (std::size_t j = i % 2; j <= n; j += 2) {
        const Integer term = f[i] * f[j];
        even[(i + j) / 2] += j % 2 == 0 ? term : Integer(-term);
      }
    f = std::move(even);
  }
  double best = -std::numeric_limits<double>::infinity();
  Integer binomial = 1;
  for (std::size_t j = 0; j <= n; ++j) {
    if (f[j] != 0) best = std::max(best, log2_lower(f[j]) - log2_upper(binomial));
    binomial = binomial * static_cast<unsigned long>(n - j) / static_cast<unsigned long>(j + 1);
  }
  return best / (1 << graeffe_steps);
}

double log2_norm_upper(const std::vector<Integer>& coefficients) {
  Integer sum = 0;
  for (const Integer& c : coefficients) sum += c * c;
  return log2_upper(sum) / 2;
}

}  // namespace exsect
