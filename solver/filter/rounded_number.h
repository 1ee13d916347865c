// Error bounds of a computation in plain doubles, for all its inputs at once. Internal to solver/;
// docs/method-equations.md, section 17.21.
#pragma once

#include <exsect/algebra/ball.h>
#include <exsect/algebra/rounding_bounds.h>

#include <cmath>

namespace exsect {

/// Bounds for a double that some computation yields: its magnitude is at most most(), and it is within
/// error() of the number that stands for it. A formula over a type T says by T = RoundedNumber what it errs
/// by for T = double, if both round to nearest and do the same operations in the same order; infinite or NaN
/// after overflow.
///
/// (17.37): a sum or difference of x and y errs by what they do, and u (|x| + |y|); a product by |x| e_y +
/// |y| e_x + e_x e_y + u |x y| + 2^-1075. Bounds are sums of at most four products of two factors: `up`
/// covers their rounding as in DoubleBall.
class RoundedNumber {
 public:
  /// The double itself.
  RoundedNumber(double x = 0) : most_(std::fabs(x)), error_(0) {}  // NOLINT: doubles are exact
  RoundedNumber(double most, double error) : most_(most), error_(error) {}
  /// The middle of the ball stands for each of its members.
  static RoundedNumber of(const DoubleBall& x) { return {std::fabs(x.approximation()), x.radius()}; }

  double most() const { return most_; }
  double error() const { return error_; }

  RoundedNumber operator-() const { return *this; }
  friend RoundedNumber operator+(const RoundedNumber& a, const RoundedNumber& b) {
    const double most = a.most_ + b.most_;
    return {up(most), up(a.error_ + b.error_ + most * kUnitRoundoff)};
  }
  friend RoundedNumber operator-(const RoundedNumber& a, const RoundedNumber& b) { return a + b; }
  friend RoundedNumber operator*(const RoundedNumber& a, const RoundedNumber& b) {
    const double most = a.most_ * b.most_;
    return {up(most),
            up(a.most_ * b.error_ + a.error_ * b.most_ + a.error_ * b.error_ + most * kUnitRoundoff)};
  }

 private:
  static double up(double r) { return r * (1 + 0x1p-48) + 0x1p-1000; }
  double most_;
  double error_;
};

}  // namespace exsect
