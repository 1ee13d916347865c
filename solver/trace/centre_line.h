// Polynomial centre lines of tubes, and the coefficients of a patch along them. Internal to solver/;
// docs/method.md, section 5.
#pragma once

#include <array>
#include <cstddef>

#include "trace/pair_system.h"

namespace exsect {

/// The degree of centre lines: where two branches are at the distance e a tube reaches about e^(1/(degree +
/// 1)).
template <class Ball>
inline constexpr std::size_t kLineDegree = 3;
template <>
inline constexpr std::size_t kLineDegree<DoubleDoubleBall> = 6;
template <long Bits>
inline constexpr std::size_t kLineDegree<ArbBall<Bits>> = 12;

/// l(sigma) = c[0] sigma + c[1] sigma² + ..., all coefficients of radius 0.
template <class Ball>
using CentreLine = std::array<BallPoint<Ball>, kLineDegree<Ball>>;

/// The products a^i b^j, i and j up to 2, of two polynomials of a degree in sigma without constant terms: by
/// coefficients of 1, sigma, sigma², ... (or magnitudes of these).
template <class Coefficient, std::size_t degree>
struct Monomials {
  using Series = std::array<Coefficient, 4 * degree + 1>;
  Series a{}, b{}, aa{}, ab{}, bb{}, aab{}, abb{}, aabb{};

  /// The coefficients of sigma^k of all products of two or more factors; requires all lower coefficients.
  void extend(std::size_t k) {
    aa[k] = product(a, a, k);
    ab[k] = product(a, b, k);
    bb[k] = product(b, b, k);
    aab[k] = product(aa, b, k);
    abb[k] = product(a, bb, k);
    aabb[k] = product(aa, bb, k);
  }

 private:
  static Coefficient product(const Series& f, const Series& g, std::size_t k) {
    Coefficient sum{};
    for (std::size_t i = 1; i < k; ++i) {
      add_product(sum, f[i], g[k - i]);
    }
    return sum;
  }
};

/// The nine coefficients of a biquadratic polynomial in the order of a TaylorNet: one row of a net.
template <class Coefficient>
using NetRow = std::array<Coefficient, 9>;

/// The coefficient of sigma^k, k > 0, of the polynomial's value along the line.
template <class Coefficient, std::size_t degree>
Coefficient value_coefficient(const NetRow<Coefficient>& c, const Monomials<Coefficient, degree>& m,
                              std::size_t k) {
  Coefficient sum = c[3] * m.a[k];
  add_product(sum, c[1], m.b[k]);
  add_product(sum, c[6], m.aa[k]);
  add_product(sum, c[4], m.ab[k]);
  add_product(sum, c[2], m.bb[k]);
  add_product(sum, c[7], m.aab[k]);
  add_product(sum, c[5], m.abb[k]);
  add_product(sum, c[8], m.aabb[k]);
  return sum;
}

/// The coefficients of sigma^k, k > 0, of the two first derivatives along the line.
template <class Coefficient, std::size_t degree>
std::array<Coefficient, 2> gradient_coefficients(const NetRow<Coefficient>& c,
                                                 const Monomials<Coefficient, degree>& m, std::size_t k) {
  std::array<Coefficient, 2> sum = {c[6] * m.a[k], c[2] * m.b[k]};
  add_product(sum[0], c[7], m.ab[k]);
  add_product(sum[0], c[8], m.abb[k]);
  add_product(sum[1], c[5], m.ab[k]);
  add_product(sum[1], c[8], m.aab[k]);
  sum[0] += sum[0];
  sum[1] += sum[1];
  add_product(sum[0], c[4], m.b[k]);
  add_product(sum[0], c[5], m.bb[k]);
  add_product(sum[1], c[4], m.a[k]);
  add_product(sum[1], c[7], m.aa[k]);
  return sum;
}

/// The coefficients of sigma^k, k > 0, of the higher g_ij(sigma), i + j > 1, where the polynomial is sum
/// g_ij(sigma) e_0^i e_1^j at l(sigma) + e; entries 0, 1 and 3 are not used.
template <class Coefficient, std::size_t degree>
NetRow<Coefficient> higher_coefficients(const NetRow<Coefficient>& c, const Monomials<Coefficient, degree>& m,
                                        std::size_t k) {
  const Coefficient two(2);
  NetRow<Coefficient> d{};
  d[6] = c[7] * m.b[k] + c[8] * m.bb[k];
  d[4] = two * (c[7] * m.a[k] + c[5] * m.b[k] + two * (c[8] * m.ab[k]));
  d[2] = c[5] * m.a[k] + c[8] * m.aa[k];
  d[7] = two * (c[8] * m.b[k]);
  d[5] = two * (c[8] * m.a[k]);
  return d;
}

}  // namespace exsect
