// A polynomial f(u,v) in the numbers with which strips are proved: balls, and in doubles midpoints with one
// bound of what all of them lose. Internal to solver/; docs/method-equations.md, section 17.4.
#pragma once

#include <exsect/algebra/ball.h>
#include <exsect/algebra/rounding_bounds.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace exsect {

inline double approximation_of(double x) { return x; }
template <class Ball>
double approximation_of(const Ball& x) {
  return x.approximation();
}
inline double midpoint_of(double x) { return x; }
template <class Ball>
Ball midpoint_of(const Ball& x) {
  return x.midpoint();
}

/// About the zero near v of the polynomial with these coefficients, by Newton's method; empty if it does not
/// come to rest within `rest`.
template <class Number>
std::optional<Number> zero_near(const std::vector<Number>& c, Number v, double rest) {
  for (int step = 0; step < 16; ++step) {
    Number value(0), slope(0);
    for (std::size_t j = c.size(); j-- > 0;) {
      slope = slope * v + value;
      value = value * v + c[j];
    }
    const double move = -approximation_of(value) / approximation_of(slope);
    if (!(std::fabs(move) <= 1)) return std::nullopt;
    v = midpoint_of(v + Number(move));
    if (std::fabs(move) <= rest) return v;
  }
  return std::nullopt;
}

/// In balls, which know what they lose: the errors beside them are 0.
template <class Ball>
class CurveNumbers {
 public:
  using Number = Ball;

  /// Of the coefficients of f, of u^i v^j at i row + j.
  CurveNumbers(const std::vector<Ball>& balls, std::size_t) : coefficients(balls) {}

  std::vector<Ball> coefficients;

  double error(double, double) const { return 0; }

  static Ball number(const Ball& x) { return x; }
  static int sign(const Ball& x) { return x.certain_sign(); }
  static double least(const Ball& x, double) { return x.lower_magnitude(); }
  static double most(const Ball& x) { return x.upper_magnitude(); }
};

/// Midpoints: sign() and most() are theirs, and the errors of all together are counted once, by error(). What
/// is infinite or NaN, as after an overflow, is not known.
template <>
class CurveNumbers<DoubleBall> {
 public:
  using Number = double;

  CurveNumbers(const std::vector<DoubleBall>& balls, std::size_t row) : row_(row) {
    const double operations = static_cast<double>(2 * (balls.size() / row_) + 5 * row_);
    for (const DoubleBall& c : balls) {
      coefficients.push_back(c.approximation());
      // What operations lose by underflow reaches f(u + x, v + y) multiplied by at most (1 + U^m) (1 + V^n).
      errors_.push_back((c.radius() + operations * kUnitRoundoff * std::fabs(c.approximation())) *
                            (1 + 4 * operations * kUnitRoundoff) +
                        kUnderflowLoss);
    }
  }

  std::vector<double> coefficients;

  /// The sum of what the coefficients of an expansion of f(u + x, v + y) are in error by, each multiplied by
  /// the powers of x and y that belong to it, for |u| + |x| <= U and |v| + |y| <= V (17.3a).
  double error(double most_u, double most_v) const {
    double sum = 0;
    for (std::size_t i = errors_.size(); i > 0; i -= row_) {
      double in_v = 0;
      for (std::size_t j = i; j-- > i - row_;) in_v = in_v * most_v + errors_[j];
      sum = sum * most_u + in_v;
    }
    return sum * kSlack;
  }

  /// A number of radius 0; with others nothing is proved.
  static double number(const DoubleBall& x) {
    return x.radius() == 0 ? x.approximation() : std::numeric_limits<double>::quiet_NaN();
  }
  static int sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
  static double least(double x, double error) {
    const double gap = std::fabs(x) * kReduced - error * kSlack;
    return gap > 0 && std::isfinite(x) ? gap : 0;
  }
  static double most(double x) { return std::fabs(x); }

 private:
  std::size_t row_;
  std::vector<double> errors_;  // by which terms with u^i v^j may be wrong
};

}  // namespace exsect
