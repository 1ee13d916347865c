// Means over the unit circle of norms of polynomials made of the numbers of a pair, in doubles with a proved
// error. Internal to solver/; docs/method.md, section 4.5.
#pragma once

#include <exsect/algebra/rational.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "curve/mahler_measure.h"

// Floating point with proved errors. The coordinates are scaled by powers of two so that every integer
// becomes a double of modulus at most 1 (relative error 2^-52, or underflow). Each quantity q below is a
// fixed expression of sums, differences and products of these numbers and of u, u^2 on the unit circle
// (relative error 2^-51) or u^3 (2^-50, as two numbers); its majorant Q is the same expression with moduli
// for numbers and sums for differences.
//  - A sum has relative error 2^-53, a complex product less than 2^-51 (R. Brent, C. Percival, P. Zimmermann,
//    Error bounds on complex floating-point multiplication, 2007). With at most 128 roundings on the way from
//    a number to q and at most 24 numbers in a product, |computed q - q| <= ((1+2^-51)^152 - 1) Q < 2^-43 Q,
//    and the computed Q is at least (1 - 2^-44) Q.
//  - Every intermediate majorant is below 2^60 and there are fewer than 2^16 operations, so that underflow
//    (at most 2^-1073 per operation) adds less than 2^-900.
// Hence |q| <= |computed q| + 2^-40 (computed Q) + 2^-400; the last term is large enough for its square.

namespace exsect {

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
inline Complex root_of_unity(std::size_t k) {
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
inline constexpr double half_of_the_roots = 16;

/// A number of the pair as one or the other.
inline Complex as(const Complex&, double number) { return {number}; }
inline Majorant as(const Majorant&, double number) { return {std::abs(number)}; }

/// The pair with each coordinate scaled by 2^-exponent.
template <std::size_t coordinates>
struct ScaledPair {
  using Net = std::vector<std::vector<std::array<double, coordinates>>>;
  Net x;
  Net y;
  std::array<long, coordinates> exponent;

  template <class Pair>
  explicit ScaledPair(const Pair& pair) {
    for (const auto& row : pair.x) x.emplace_back(row.size());
    for (const auto& row : pair.y) y.emplace_back(row.size());
    for (std::size_t k = 0; k < coordinates; ++k) {
      exponent[k] = std::numeric_limits<long>::min();
      const auto for_each = [&](const auto& function) {
        for (std::size_t i = 0; i < x.size(); ++i)
          for (std::size_t j = 0; j < x[i].size(); ++j) function(pair.x[i][j][k], x[i][j][k]);
        for (std::size_t i = 0; i < y.size(); ++i)
          for (std::size_t j = 0; j < y[i].size(); ++j) function(pair.y[i][j][k], y[i][j][k]);
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

/// Half of log2 of the mean over the unit circle of the squared 2-norm of each coefficient vector that
/// `forms` gives over u, a Complex, or as majorants over the Majorant 1: exact by Parseval's identity on 32
/// nodes (degree in u at most 31), rounded upwards.
template <class Forms>
auto log2_mean_norms(const Forms& forms) {
  const auto bound = forms(Majorant{1});
  std::array<double, std::tuple_size_v<decltype(bound)>> sums{};
  for (std::size_t node = 0; node <= 16; ++node) {
    const auto values = forms(root_of_unity(node));
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

}  // namespace exsect
