// A plane curve f(u,v) = 0 in ball arithmetic: strips whose edges it does not meet. Internal to solver/;
// docs/method-equations.md, section 17.4.
#pragma once

#include <exsect/algebra/ball.h>
#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/rounding_bounds.h>

#include <cmath>
#include <optional>
#include <vector>

#include "curve/curve_numbers.h"
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
  using Numbers = CurveNumbers<Ball>;
  using Number = typename Numbers::Number;

 public:
  /// Of f != 0, u in the place of r and v in that of s.
  explicit PlaneStrip(const BivariatePolynomial& f)
      : n_(static_cast<std::size_t>(f.degree_s())),
        c_(enclosed_coefficients<Ball>(f, greatest_coefficient(f))),
        f_(c_, n_ + 1) {}

  /// About the zero of f(u,.) near v, by Newton's method; empty if it does not come to rest within `rest`. u
  /// and v are of radius 0, here and below.
  std::optional<Ball> zero_near(const Ball& u, const Ball& v, double rest) const {
    const std::vector<Number> c = coefficients_over(f_.coefficients, n_ + 1, Numbers::number(u));
    const std::optional<Number> zero = exsect::zero_near(c, Numbers::number(v), rest);
    if (!zero) return std::nullopt;
    return Ball(*zero);
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
    const double rise = std::fabs(slope.approximation()) * reach * kSlack;
    const double error =
        f_.error((u.upper_magnitude() + reach) * kSlack, (v.upper_magnitude() + rise + w) * kSlack);
    std::vector<Number> c = f_.coefficients;
    shift_to(c, n_ + 1, Numbers::number(u), Numbers::number(v));
    for (const bool above : {false, true}) {
      const double edge = above ? w : -w, at = v.approximation() + edge;
      if (at - rise > 1 + 0x1p-48 || at + rise < -0x1p-48) continue;  // outside the square throughout
      if (!has_sign(along_line(c, n_ + 1, Numbers::number(slope), Number(edge)), reach, error))
        return std::nullopt;
    }
    if (!(off < w)) return std::nullopt;
    return off;
  }

  /// f(u, v + e) for |e| <= w is monotone in e; a bound of |e| for its zero. Empty if that is not proved.
  std::optional<double> distance_of_zero(const StripPoint<Ball>& at, double w) const {
    std::vector<Ball> c = coefficients_over(c_, n_ + 1, at.u);
    for (std::size_t k = 0; k < n_; ++k)
      for (std::size_t j = n_; j-- > k;) c[j] += at.v * c[j + 1];
    double least = n_ > 0 ? c[1].lower_magnitude() : 0, power = w;
    for (std::size_t j = 2; j <= n_; ++j, power *= w)
      least -= static_cast<double>(j) * c[j].upper_magnitude() * power * kSlack;
    if (n_ == 0 || !(least > c[1].lower_magnitude() * 0x1p-30)) return std::nullopt;
    return c[0].upper_magnitude() / least * kSlack + kUnderflowLoss;
  }

 private:
  /// The polynomial, with coefficients that are together in error by `error` for |x| <= reach, has one sign,
  /// and no zero, there. A square of that sign is left out: it only helps, but for its error.
  static bool has_sign(const std::vector<Number>& f, double reach, double error) {
    double others = 0, power = reach;
    for (std::size_t i = 1; i < f.size(); ++i, power *= reach * kSlack) {
      const bool helps = i == 2 && Numbers::sign(f[2]) != 0 && Numbers::sign(f[2]) == Numbers::sign(f[0]);
      if (!helps) others += Numbers::most(f[i]) * power;
    }
    return Numbers::least(f[0], error) > others * kSlack + kUnderflowLoss;
  }

  std::size_t n_;
  std::vector<Ball> c_;  // of u^i v^j at i (n + 1) + j
  Numbers f_;
};

}  // namespace exsect
