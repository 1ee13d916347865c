#include "eliminant/eliminant_height.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "curve/mahler_measure.h"
#include "eliminant/circle_means.h"
#include "eliminant/fibre_forms.h"

namespace exsect {

namespace {

using FormalIntegerPolynomial = FormalPolynomial<Integer>;

/// n = a_1 x a_2, g_r and g_s as polynomials in u (4.5).
struct LeadingForms {
  SpaceVector<FormalIntegerPolynomial> n;
  FormalIntegerPolynomial g_r;
  FormalIntegerPolynomial g_s;

  explicit LeadingForms(const IntegerPair& pair) {
    const auto line = [&](std::size_t j) {
      SpaceVector<FormalIntegerPolynomial> a;
      for (std::size_t k = 0; k < 3; ++k)
        a[k].coefficients = {pair.x[0][j][k], pair.x[1][j][k], pair.x[2][j][k]};
      return a;
    };
    n = cross_product(line(1), line(2));
    const auto g = [&](const SpaceVector<Integer>& c0, const SpaceVector<Integer>& c1,
                       const SpaceVector<Integer>& c2) {
      const auto bracket = [&](const SpaceVector<Integer>& c, const SpaceVector<Integer>& d) {
        return dot_product(cross_product(c, d), line(2));
      };
      return bracket(c0, c2) * bracket(c0, c2) - bracket(c1, c2) * bracket(c0, c1);
    };
    g_r = g(pair.y[2][0], pair.y[2][1], pair.y[2][2]);
    g_s = g(pair.y[0][2], pair.y[1][2], pair.y[2][2]);
  }
};

/// At u, a Complex or the Majorant 1.
template <class T>
FibreCoefficients<T> fibre_at(const ScaledPair<3>& pair, const T& u) {
  const T u_square = u * u;
  FibreCoefficients<T> result;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k) {
      result.a[j][k] =
          as(u, pair.x[0][j][k]) + u * as(u, pair.x[1][j][k]) + u_square * as(u, pair.x[2][j][k]);
      for (std::size_t i = 0; i < 3; ++i) result.y[i][j][k] = as(u, pair.y[i][j][k]);
    }
  return result;
}

}  // namespace

HeightTerms height_terms(const IntegerPair& pair) {
  const LeadingForms leading(pair);
  const auto g_r = measure_lower(leading.g_r.coefficients);
  const auto g_s = measure_lower(leading.g_s.coefficients);
  if (!g_r || !g_s) throw std::domain_error("eliminant_height: g_r or g_s vanishes identically");
  const ScaledPair<3> scaled(pair);
  // J, R, and n_k J scale with the first, fourth, first power of the product of the three scales, times n_k.
  const auto scale = static_cast<double>(scaled.exponent[0] + scaled.exponent[1] + scaled.exponent[2]);

  const auto norms = log2_mean_norms([&](const auto& u) { return turning_forms(fibre_at(scaled, u)); });
  std::optional<double> jacobian;  // the best k
  for (std::size_t k = 0; k < 3; ++k) {
    const auto n = measure_lower(leading.n[k].coefficients);
    if (!n) continue;
    const double scale_of_n = scale - static_cast<double>(scaled.exponent[k]);
    const double log2_six = 2.585;  // of 36 terms, by Cauchy and Schwarz
    const double bound = log2_six + norms[k] + scale + scale_of_n - *n;
    jacobian = jacobian ? std::min(*jacobian, bound) : bound;
  }
  if (!jacobian) throw std::domain_error("eliminant_height: a_1 x a_2 vanishes identically");
  const auto [r_s, r_r] = log2_mean_norms([&](const auto& u) {
    const auto f = fibre_at(scaled, u);
    return std::array{fibre_eliminant(FibreForms(f)).r.coefficients,
                      fibre_eliminant(FibreForms(f.exchanged())).r.coefficients};
  });
  return {*jacobian, r_s + 4 * scale, r_r + 4 * scale, *g_r, *g_s};
}

// (4.16)
std::size_t eliminant_height_bound(const IntegerPair& pair) {
  const HeightTerms t = height_terms(pair);
  const double log2_binomial = 124.2;  // binom(128,64) < 2^124.2
  const double bits = 16 * t.jacobian + 5 * (t.r_s + t.r_r) - 4 * (t.g_r + t.g_s) + log2_binomial;
  // The sum of these doubles, each below 2^40, is rounded by less than 1.
  return static_cast<std::size_t>(std::ceil(std::max(bits, 0.0))) + 1;
}

}  // namespace exsect
