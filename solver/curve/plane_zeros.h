// Zeros of a plane curve f(u,v) = 0 over numbers u, in ball arithmetic. Internal to solver/;
// docs/method-equations.md, section 17.6.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/rounding_bounds.h>

#include <cmath>
#include <optional>
#include <vector>

#include "curve/curve_numbers.h"
#include "curve/taylor_shift.h"

namespace exsect {

template <class Ball>
class PlaneZeros {
 public:
  /// Of f != 0, u in the place of r and v in that of s.
  explicit PlaneZeros(const BivariatePolynomial& f)
      : row_(static_cast<std::size_t>(f.degree_s()) + 1),
        c_(enclosed_coefficients<Ball>(f, greatest_coefficient(f))) {}

  /// An enclosure of a zero of f(u,.) that a ball is known to contain, of a radius from about `least` on, if
  /// it is proved to be the one meant: by the changes of sign in the Bernstein coefficients on a slightly
  /// wider interval, and one of f around what Newton's method finds. With one change there is no other zero.
  /// With two it is told by `below`, the sign of f(u,.) next below it (17.6d); 0 if that is not known.
  std::optional<Ball> only_zero(const Ball& u, const Ball& range, int below = 0,
                                double least = 0x1p-50) const {
    const double middle = range.approximation(), reach = range.upper_magnitude();
    const double room = range.radius() * 0x1p-5 + reach * 0x1p-40 + kUnderflowLoss;
    const double lower = middle - range.radius() - room, width = 2 * (range.radius() + room);
    const std::vector<Ball> c = coefficients_over(c_, row_, u);
    const SignChanges changes = sign_changes(c, Ball(lower), Ball(width));
    const bool is_one_of_two = changes.number == 2 && below != 0;
    if (changes.number != 1 && !is_one_of_two) return std::nullopt;
    const double from = !is_one_of_two ? middle : changes.first == below ? lower : lower + width;
    const std::optional<Ball> v = zero_near(c, Ball(from), least * 0x1p10);
    if (!v) return std::nullopt;
    for (double w = least; w < 0x1p-22; w *= 16) {
      const Ball under = *v - Ball(w), above = *v + Ball(w);
      if (!(under - Ball(lower)).is_positive() || !(Ball(lower) + Ball(width) - above).is_positive())
        return std::nullopt;
      const int sign = value(c, under).certain_sign();
      if (sign * value(c, above).certain_sign() >= 0) continue;
      if (is_one_of_two && sign != below) return std::nullopt;
      return v->widened(w * kSlack);
    }
    return std::nullopt;
  }

 private:
  static Ball value(const std::vector<Ball>& c, const Ball& v) {
    Ball sum;
    for (std::size_t j = c.size(); j-- > 0;) sum = sum * v + c[j];
    return sum;
  }

  /// How often the Bernstein coefficients of a polynomial change their sign, -1 if that is not known, and the
  /// first sign.
  struct SignChanges {
    int number;
    int first;
  };
  /// On [lower, lower + width]; one coefficient between others of two signs may be of any. The polynomial has
  /// exactly one zero there if it is 1, a simple one inside; two or none, counted with multiplicities, if it
  /// is 2.
  static SignChanges sign_changes(std::vector<Ball> c, const Ball& lower, const Ball& width) {
    const std::size_t n = c.size() - 1;
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = n; j-- > k;) c[j] += lower * c[j + 1];
    Ball power(1);
    double binomial = 1;
    for (std::size_t j = 0; j <= n; ++j) {
      c[j] = c[j] * power * Ball(1 / binomial).widened(0x1p-52 / binomial);
      power *= width;
      binomial = binomial * static_cast<double>(n - j) / static_cast<double>(j + 1);
    }
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = n; j > k; --j) c[j] += c[j - 1];
    const int first = c[0].certain_sign();
    int changes = 0, before = first;
    bool is_unknown = first == 0;  // the sign of the coefficient before
    for (std::size_t j = 1; j <= n; ++j) {
      const int sign = c[j].certain_sign();
      if (is_unknown && (sign == 0 || sign == before)) return {-1, first};
      is_unknown = sign == 0;
      if (is_unknown) continue;
      if (sign != before) ++changes;
      before = sign;
    }
    return {is_unknown || first == 0 ? -1 : changes, first};
  }

  std::size_t row_;
  std::vector<Ball> c_;  // of u^i v^j at i row + j
};

}  // namespace exsect
