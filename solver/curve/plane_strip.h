// A plane curve f(u,v) = 0 in ball arithmetic: strips whose edges it does not meet. Internal to solver/;
// docs/method-equations.md, section 17.4.
#pragma once

#include <exsect/algebra/ball.h>
#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "curve/taylor_shift.h"

namespace exsect {

/// A point (u,v), both of radius 0.
template <class Ball>
struct StripPoint {
  Ball u;
  Ball v;
};

template <class Ball>
class PlaneStrip {
 public:
  /// Of f != 0, u in the place of r and v in that of s.
  explicit PlaneStrip(const BivariatePolynomial& f)
      : m_(static_cast<std::size_t>(f.degree_r())), n_(static_cast<std::size_t>(f.degree_s())) {
    c_ = enclosed_coefficients<Ball>(f, greatest_coefficient(f));
  }

  /// About the zero of f(u,.) near v, by Newton's method; empty if it does not come to rest within `rest`.
  std::optional<Ball> zero_near(const Ball& u, const Ball& v, double rest) const {
    return zero_near(over(u), v, rest);
  }

  /// An enclosure of a zero of f(u,.) that a ball is known to contain, of a radius from about `least` on, if
  /// it is proved to be the one meant: by the changes of sign in the Bernstein coefficients on a slightly
  /// wider interval, and one of f around what Newton's method finds. With one change there is no other zero.
  /// With two it is told by `below`, the sign of f(u,.) next below it (17.6d); 0 if that is not known.
  std::optional<Ball> only_zero(const Ball& u, const Ball& range, int below = 0,
                                double least = 0x1p-50) const {
    const double middle = range.approximation(), reach = range.upper_magnitude();
    const double room = range.radius() * 0x1p-5 + reach * 0x1p-40 + kUnderflowLoss;
    const double lower = middle - range.radius() - room, width = 2 * (range.radius() + room);
    const std::vector<Ball> c = over(u);
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

  /// Proves that f has no zero on the two edges v = l(u) - w and v = l(u) + w of the strip around a line l,
  /// as far as they are in the square, for u from a.u to b.u and `slack` beyond both; a bound of |l - v| in a
  /// and b, less than w. Empty if it is not proved.
  std::optional<double> clear(const StripPoint<Ball>& a, const StripPoint<Ball>& b, double w,
                              double slack) const {
    const Ball half(0.5);
    const Ball u = ((a.u + b.u) * half).midpoint(), v = ((a.v + b.v) * half).midpoint();
    const Ball du = b.u - a.u, dv = b.v - a.v;
    const Ball slope(dv.approximation() / du.approximation());
    const double reach =
        larger_bound((a.u - u).upper_magnitude(), (b.u - u).upper_magnitude()) * kSlack + slack;
    const double off = larger_bound((a.v - v - slope * (a.u - u)).upper_magnitude(),
                                    (b.v - v - slope * (b.u - u)).upper_magnitude());
    const LineExpansion<Ball> f(c_, n_ + 1, u, v, slope, w);
    const double rise = std::fabs(slope.approximation()) * reach * kSlack;
    for (const bool above : {false, true}) {
      const double at = v.approximation() + (above ? w : -w);
      if (at - rise > 1 + 0x1p-48 || at + rise < -0x1p-48) continue;  // outside the square throughout
      if (!has_sign(f.at(above), reach)) return std::nullopt;
    }
    if (!(off < w)) return std::nullopt;
    return off;
  }

  /// f(u, v + e) for |e| <= w is monotone in e; a bound of |e| for its zero. Empty if that is not proved.
  std::optional<double> distance_of_zero(const StripPoint<Ball>& at, double w) const {
    std::vector<Ball> c = over(at.u);
    for (std::size_t k = 0; k < n_; ++k)
      for (std::size_t j = n_; j-- > k;) c[j] += at.v * c[j + 1];
    double least = n_ > 0 ? c[1].lower_magnitude() : 0, power = w;
    for (std::size_t j = 2; j <= n_; ++j, power *= w)
      least -= static_cast<double>(j) * c[j].upper_magnitude() * power * kSlack;
    if (n_ == 0 || !(least > c[1].lower_magnitude() * 0x1p-30)) return std::nullopt;
    return c[0].upper_magnitude() / least * kSlack + kUnderflowLoss;
  }

 private:
  /// Coefficients of f(u,.).
  std::vector<Ball> over(const Ball& u) const {
    std::vector<Ball> c(n_ + 1);
    for (std::size_t i = m_ + 1; i-- > 0;)
      for (std::size_t j = 0; j <= n_; ++j) c[j] = c[j] * u + c_[i * (n_ + 1) + j];
    return c;
  }

  /// About the zero near v of the polynomial with these coefficients.
  static std::optional<Ball> zero_near(const std::vector<Ball>& c, Ball v, double rest) {
    for (int step = 0; step < 16; ++step) {
      Ball value, slope;
      for (std::size_t j = c.size(); j-- > 0;) {
        slope = slope * v + value;
        value = value * v + c[j];
      }
      const double move = -value.approximation() / slope.approximation();
      if (!(std::fabs(move) <= 1)) return std::nullopt;
      v = (v + Ball(move)).midpoint();
      if (std::fabs(move) <= rest) return v;
    }
    return std::nullopt;
  }

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

  /// The polynomial has one sign, and no zero, for |x| <= reach. A square of that sign is left out: it only
  /// helps.
  static bool has_sign(const std::vector<Ball>& f, double reach) {
    double others = 0, power = reach;
    for (std::size_t i = 1; i < f.size(); ++i, power *= reach * kSlack) {
      const bool helps = i == 2 && f[2].certain_sign() != 0 && f[2].certain_sign() == f[0].certain_sign();
      if (!helps) others += f[i].upper_magnitude() * power;
    }
    return f[0].lower_magnitude() > others * kSlack + kUnderflowLoss;
  }

  std::size_t m_;
  std::size_t n_;
  std::vector<Ball> c_;  // of u^i v^j at i (n + 1) + j
};

}  // namespace exsect
