#include "eliminant/eliminant_height.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "curve/mahler_measure.h"
#include "eliminant/fibre_forms.h"

// Floating point with proved errors. The coordinates are scaled by powers of two so that every integer
// becomes a double of modulus at most 1 (relative error 2^-52, or underflow). Each quantity q below is a
// fixed expression of sums, differences and products of these numbers and of u and u^2 on the unit circle
// (relative error 2^-51); its majorant Q is the same expression with moduli for numbers and sums for
// differences.
//  - A sum has relative error 2^-53, a complex product less than 2^-51 (R. Brent, C. Percival, P. Zimmermann,
//    Error bounds on complex floating-point multiplication, 2007). With at most 128 roundings on the way from
//    a number to q and at most 24 numbers in a product, |computed q - q| <= ((1+2^-51)^152 - 1) Q < 2^-43 Q,
//    and the computed Q is at least (1 - 2^-44) Q.
//  - Every intermediate majorant is below 2^60 and there are fewer than 2^16 operations, so that underflow
//    (at most 2^-1073 per operation) adds less than 2^-900.
// Hence |q| <= |computed q| + 2^-40 (computed Q) + 2^-400; the last term is large enough for its square.

namespace exsect {

namespace {

struct Complex {
  double re = 0;
  double im = 0;

  friend Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }
  friend Complex operator-(const Complex& a, const Complex& b) { return {a.re - b.re, a.im - b.im}; }
  friend Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
};

struct Majorant {
  double value = 0;

  friend Majorant operator+(Majorant a, Majorant b) { return {a.value + b.value}; }
  friend Majorant operator-(Majorant a, Majorant b) { return {a.value + b.value}; }
  friend Majorant operator*(Majorant a, Majorant b) { return {a.value * b.value}; }
};

/// exp(i k pi/16), 0 <= k <= 16; the other half of the 32nd roots of unity are the conjugates.
Complex root_of_unity(std::size_t k) {
  static constexpr std::array<double, 9> cosines = {1.0,
                                                    0.980785280403230449,
                                                    0.923879532511286756,
                                                    0.831469612302545237,
                                                    0.707106781186547524,
                                                    0.555570233019602225,
                                                    0.382683432365089772,
                                                    0.195090322016128268,
                                                    0.0};
  return k <= 8 ? Complex{cosines[k], cosines[8 - k]} : Complex{-cosines[16 - k], cosines[k - 8]};
}
constexpr double half_of_the_roots = 16;

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

/// The pair with each coordinate scaled by 2^-exponent.
struct ScaledPair {
  std::array<std::array<std::array<double, 3>, 3>, 3> x;
  std::array<std::array<std::array<double, 3>, 3>, 3> y;
  std::array<long, 3> exponent;

  explicit ScaledPair(const IntegerPair& pair) {
    for (std::size_t k = 0; k < 3; ++k) {
      exponent[k] = std::numeric_limits<long>::min();
      const auto for_each = [&](const auto& function) {
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) {
            function(pair.x[i][j][k], x[i][j][k]);
            function(pair.y[i][j][k], y[i][j][k]);
          }
      };
      for_each([&](const Integer& a, double&) {
        if (a != 0) exponent[k] = std::max(exponent[k], scaled_double(a).exponent);
      });
      for_each([&](const Integer& a, double& scaled) {
        const ScaledDouble s = scaled_double(a);
        const long shift = a == 0 ? 0 : std::max(s.exponent - exponent[k], -2000L);
        scaled = std::ldexp(s.mantissa, static_cast<int>(shift));
      });
    }
  }
};

FibreCoefficients<Complex> at_root_of_unity(const ScaledPair& pair, std::size_t node) {
  const Complex u = root_of_unity(node);
  const Complex u_square = u * u;
  FibreCoefficients<Complex> result;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k) {
      result.a[j][k] =
          Complex{pair.x[0][j][k]} + u * Complex{pair.x[1][j][k]} + u_square * Complex{pair.x[2][j][k]};
      for (std::size_t i = 0; i < 3; ++i) result.y[i][j][k] = {pair.y[i][j][k]};
    }
  return result;
}

FibreCoefficients<Majorant> majorant(const ScaledPair& pair) {
  FibreCoefficients<Majorant> result;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k) {
      result.a[j][k] = {std::abs(pair.x[0][j][k]) + std::abs(pair.x[1][j][k]) + std::abs(pair.x[2][j][k])};
      for (std::size_t i = 0; i < 3; ++i) result.y[i][j][k] = {std::abs(pair.y[i][j][k])};
    }
  return result;
}

/// Half of log2 of the mean over the unit circle of the squared 2-norm of each coefficient vector that
/// `forms` gives for a fibre: exact by Parseval's identity on 32 nodes (degree in u at most 31), rounded
/// upwards.
template <class Forms>
auto log2_mean_norms(const ScaledPair& pair, const Forms& forms) {
  const auto bound = forms(majorant(pair));
  std::array<double, std::tuple_size_v<decltype(bound)>> sums{};
  for (std::size_t node = 0; node <= 16; ++node) {
    const auto values = forms(at_root_of_unity(pair, node));
    const double weight = node == 0 || node == 16 ? 0.5 : 1;
    for (std::size_t k = 0; k < sums.size(); ++k)
      for (std::size_t i = 0; i < values[k].size(); ++i) {
        const Complex& value = values[k][i];
        const double modulus =
            std::sqrt(value.re * value.re + value.im * value.im) + 0x1p-40 * bound[k][i].value + 0x1p-400;
        sums[k] += weight * modulus * modulus;
      }
  }
  for (double& sum : sums) sum = log2_upper(sum * kSlack / half_of_the_roots) / 2;
  return sums;
}

}  // namespace

HeightTerms height_terms(const IntegerPair& pair) {
  const LeadingForms leading(pair);
  const auto g_r = measure_lower(leading.g_r.coefficients);
  const auto g_s = measure_lower(leading.g_s.coefficients);
  if (!g_r || !g_s) throw std::domain_error("eliminant_height: g_r or g_s vanishes identically");
  const ScaledPair scaled(pair);
  // J, R, and n_k J scale with the first, fourth, first power of the product of the three scales, times n_k.
  const auto scale = static_cast<double>(scaled.exponent[0] + scaled.exponent[1] + scaled.exponent[2]);

  const auto norms = log2_mean_norms(scaled, [](const auto& f) { return turning_forms(f); });
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
  const auto [r_s, r_r] = log2_mean_norms(scaled, [](const auto& f) {
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
