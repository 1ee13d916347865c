// Real numbers in doubles with a proved bound of their errors.
#pragma once

#include <exsect/algebra/rational.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace exsect::checker {

/// A real number a, of which |a - value| <= error is known. A comparison is true only if it is certain: a < b
/// and b <= a may both be false.
///
/// A result v of the processor is within 2^-53 |v| of the exact one, or within 2^-1074 where it underflows.
/// The errors below are sums and quotients of non-negative terms, by fewer than ten roundings: the factor
/// 1 + 2^-49 and the term 2^-1000 of `rounded` make up for these. A value that overflows has the error
/// infinity, with which nothing is certain, as with NaN.
class Enclosure {
 public:
  Enclosure(int n = 0) : value_(n) {}
  explicit Enclosure(double exact) : value_(exact) {}
  explicit Enclosure(const Rational& q) : value_(to_double(q)) {
    if (!std::isfinite(value_) || from_double(value_) != q) *this = rounded(value_, 0);
  }
  /// Of a number within `radius` of q.
  Enclosure(const Rational& q, const Rational& radius) : Enclosure(q) {
    if (radius != 0) *this = rounded(value_, error_ + to_double(radius));
  }

  friend double approximate(const Enclosure& a) { return a.value_; }

  friend Enclosure operator-(const Enclosure& a) { return {-a.value_, a.error_}; }
  friend Enclosure operator+(const Enclosure& a, const Enclosure& b) {
    return rounded(a.value_ + b.value_, a.error_ + b.error_);
  }
  friend Enclosure operator-(const Enclosure& a, const Enclosure& b) {
    return rounded(a.value_ - b.value_, a.error_ + b.error_);
  }
  friend Enclosure operator*(const Enclosure& a, const Enclosure& b) {
    return rounded(a.value_ * b.value_,
                   std::abs(a.value_) * b.error_ + a.error_ * (std::abs(b.value_) + b.error_));
  }
  /// |a/b - q| = |a - q b| / |b| <= (error of a + |q| error of b) / (|b| - error of b), q the quotient of
  /// values.
  friend Enclosure operator/(const Enclosure& a, const Enclosure& b) {
    const double q = a.value_ / b.value_;
    const double least = std::abs(b.value_) - b.error_ * (1 + 0x1p-49);
    if (!(least > 0)) return {q, std::numeric_limits<double>::infinity()};
    return rounded(q, (a.error_ + std::abs(q) * b.error_) / least);
  }
  /// Nothing is rounded but what underflows.
  friend Enclosure half(const Enclosure& a) {
    return {a.value_ / 2, (a.error_ / 2 + 0x1p-1000) * (1 + 0x1p-49)};
  }
  Enclosure& operator+=(const Enclosure& a) { return *this = *this + a; }
  Enclosure& operator-=(const Enclosure& a) { return *this = *this - a; }

  friend bool operator<(const Enclosure& a, const Enclosure& b) {
    return b.value_ - a.value_ > (a.error_ + b.error_) * (1 + 0x1p-49);
  }
  friend bool operator<=(const Enclosure& a, const Enclosure& b) {
    return b.value_ - a.value_ >= (a.error_ + b.error_) * (1 + 0x1p-49);
  }
  friend bool operator>(const Enclosure& a, const Enclosure& b) { return b < a; }
  friend bool operator>=(const Enclosure& a, const Enclosure& b) { return b <= a; }
  friend bool operator==(const Enclosure& a, const Enclosure& b) { return a <= b && b <= a; }

  friend Enclosure magnitude(const Enclosure& a) { return {std::abs(a.value_), a.error_}; }
  friend Enclosure larger(const Enclosure& a, const Enclosure& b) {
    return {std::max(a.value_, b.value_), std::max(a.error_, b.error_)};
  }
  /// A number that is at least the square root.
  friend Enclosure root_above(const Enclosure& a) {
    return Enclosure(std::sqrt(a.value_ + a.error_) * (1 + 0x1p-49) + 0x1p-500);
  }

 private:
  Enclosure(double value, double error) : value_(value), error_(error) {}
  static Enclosure rounded(double value, double error) {
    return {value, (error + std::abs(value) * 0x1p-53) * (1 + 0x1p-49) + 0x1p-1000};
  }

  double value_;
  double error_ = 0;
};

inline Rational half(const Rational& q) { return q / 2; }
inline double approximate(const Rational& q) { return to_double(q); }
inline double approximate(double a) { return a; }

}  // namespace exsect::checker
