// Enclosures of real numbers: midpoint-radius balls whose midpoints are unevaluated sums of two doubles.
#pragma once

#include <exsect/algebra/ball.h>

#include <cmath>

namespace exsect {

/// The reals x with |x - hi - lo| <= rad, |lo| at most half a unit in the last place of hi: about 106 bits.
/// The operations of DoubleBall (ball.h), some ten times as fast as those of ArbBall.
///
/// Rounding, u and eta as for DoubleBall: the rounding error of a sum is a double (Knuth), and that of a
/// product but for eta, by a fused multiplication (Dekker). The other roundings are bounded one by one. A
/// radius is a sum of at most ten nonnegative terms of at most three rounded factors each: less than (1 +
/// 2^-48) is lost, and 2^-1000 covers underflow. After overflow the radius is infinite or NaN, and every
/// predicate is false.
class DoubleDoubleBall {
 public:
  DoubleDoubleBall() : DoubleDoubleBall(0.0) {}
  /// Exactly x.
  DoubleDoubleBall(double x) : hi_(x), lo_(0), rad_(0) {}  // NOLINT: doubles are balls of radius 0
  DoubleDoubleBall(double mid, double rad) : hi_(mid), lo_(0), rad_(rad) {}
  /// Exactly the sum.
  static DoubleDoubleBall sum(double a, double b) {
    const Exact s = two_sum(a, b);
    return {s.value, s.error, 0};
  }
  /// A ball around q of relative radius at most 2^-104.
  static DoubleDoubleBall enclosing(const Rational& q);
  /// The smallest convenient ball containing the closed interval.
  static DoubleDoubleBall enclosing(const RationalInterval& interval);

  /// The midpoint as a ball of radius 0.
  DoubleDoubleBall midpoint() const { return {hi_, lo_, 0}; }
  /// The same midpoint, radius enlarged by r >= 0.
  DoubleDoubleBall widened(double r) const { return {hi_, lo_, up(rad_ + r)}; }
  double approximation() const { return hi_; }
  /// The midpoint less approximation(), exactly.
  double remainder() const { return lo_; }
  /// Upper bound of the radius.
  double radius() const { return rad_; }
  /// Upper bound of |x| over the ball.
  double upper_magnitude() const { return up(std::fabs(hi_) + std::fabs(lo_) + rad_); }
  /// Lower bound of |x| over the ball, 0 if it may contain 0.
  double lower_magnitude() const {
    const double gap = std::fabs(hi_) * (1 - 0x1p-50) - rad_ * (1 + 0x1p-50);
    return gap > 0 ? gap : 0;
  }
  bool is_positive() const { return hi_ > 0 && lower_magnitude() > 0; }
  bool is_negative() const { return hi_ < 0 && lower_magnitude() > 0; }
  /// +1 or -1 if every member has that sign, else 0: "not known".
  int certain_sign() const { return is_positive() ? 1 : is_negative() ? -1 : 0; }
  RationalInterval interval() const;

  DoubleDoubleBall operator-() const { return {-hi_, -lo_, rad_}; }
  friend DoubleDoubleBall operator+(const DoubleDoubleBall& a, const DoubleDoubleBall& b) {
    const Exact s = two_sum(a.hi_, b.hi_);
    const double low = a.lo_ + b.lo_;
    const double rest = s.error + low;
    const Exact m = two_sum(s.value, rest);
    return {m.value, m.error, up(a.rad_ + b.rad_ + (std::fabs(low) + std::fabs(rest)) * 0x1p-53)};
  }
  friend DoubleDoubleBall operator-(const DoubleDoubleBall& a, const DoubleDoubleBall& b) { return a + -b; }
  friend DoubleDoubleBall operator*(const DoubleDoubleBall& a, const DoubleDoubleBall& b) {
    const double p = a.hi_ * b.hi_;
    const double error = std::fma(a.hi_, b.hi_, -p);
    const double ab = a.hi_ * b.lo_;
    const double ba = a.lo_ * b.hi_;
    const double low = ab + ba;
    const double rest = error + low;
    const Exact m = two_sum(p, rest);
    const double rounding = (std::fabs(ab) + std::fabs(ba) + std::fabs(low) + std::fabs(rest)) * 0x1p-53;
    return {m.value, m.error,
            up(rounding + std::fabs(a.lo_ * b.lo_) + (std::fabs(a.hi_) + std::fabs(a.lo_)) * b.rad_ +
               a.rad_ * (std::fabs(b.hi_) + std::fabs(b.lo_) + b.rad_))};
  }
  DoubleDoubleBall& operator+=(const DoubleDoubleBall& b) { return *this = *this + b; }
  DoubleDoubleBall& operator-=(const DoubleDoubleBall& b) { return *this = *this - b; }
  DoubleDoubleBall& operator*=(const DoubleDoubleBall& b) { return *this = *this * b; }

 private:
  DoubleDoubleBall(double hi, double lo, double rad) : hi_(hi), lo_(lo), rad_(rad) {}

  /// value + error, exactly.
  struct Exact {
    double value;
    double error;
  };
  static Exact two_sum(double a, double b) {
    const double s = a + b;
    const double part = s - a;
    return {s, (a - (s - part)) + (b - part)};
  }
  static double up(double r) { return r * (1 + 0x1p-47) + 0x1p-1000; }

  double hi_;
  double lo_;
  double rad_;
};

}  // namespace exsect
