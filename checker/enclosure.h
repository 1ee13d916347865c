// Real numbers in doubles with a proved bound of their errors.
#pragma once

#include <exsect/algebra/rational.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace exsect::checker {

/// A real number a, of which |a - value| <= error is known. A comparison is true only if it is certain: a < b
/// and b <= a may both be false.
///
/// Always true: |value| + error is finite, or nothing is known of the number, which is written as value 0
/// and error infinity. NaN is never stored, so nothing can drop it; what is not known makes every result
/// unknown and every comparison false.
///
/// The model of the processor, which FloatingPoint (floating_point.h) sets for the time of a check: IEEE 754
/// binary64, rounded to nearest, subnormal numbers kept. A result v is within 2^-53 |v| of the exact one, or
/// within 2^-1074 where it underflows. The errors below are sums and quotients of non-negative terms, by
/// fewer than ten roundings: the factor 1 + 2^-49 and the term 2^-1000 of `rounded` make up for these.
class Enclosure {
 public:
  Enclosure(int n = 0) : value_(n) {}
  explicit Enclosure(double exact) : Enclosure(exact, 0) {}
  explicit Enclosure(const Rational& q) : Enclosure(to_double(q)) {
    if (!is_known() || from_double(value_) != q) *this = rounded(value_, error_);
  }
  /// Of a number within `radius` of q.
  Enclosure(const Rational& q, const Rational& radius) : Enclosure(q) {
    if (radius != 0) *this = rounded(value_, error_ + to_double(radius));
  }

  /// A double that is at least the number; infinite if none is known.
  double above() const { return std::nextafter(value_ + error_, std::numeric_limits<double>::infinity()); }
  friend double approximate(const Enclosure& a) { return a.value_; }

  friend Enclosure operator-(const Enclosure& a) { return {-a.value_, a.error_}; }
  friend Enclosure operator+(const Enclosure& a, const Enclosure& b) {
    return rounded(a.value_ + b.value_, a.error_ + b.error_);
  }
  friend Enclosure operator-(const Enclosure& a, const Enclosure& b) {
    return rounded(a.value_ - b.value_, a.error_ + b.error_);
  }
  /// sum + a b, rounded together.
  friend void add_multiple(Enclosure& sum, const Enclosure& a, const Enclosure& b) {
    const double product = a.value_ * b.value_;
    const double error = std::abs(a.value_) * b.error_ + a.error_ * (std::abs(b.value_) + b.error_);
    sum = rounded(sum.value_ + product, sum.error_ + error + std::abs(product) * 0x1p-53);
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
    if (!(least > 0)) return unknown();
    return rounded(q, (a.error_ + std::abs(q) * b.error_) / least);
  }
  /// Nothing is rounded but what underflows.
  friend Enclosure half(const Enclosure& a) {
    return {a.value_ / 2, (a.error_ / 2 + 0x1p-1000) * (1 + 0x1p-49)};
  }
  Enclosure& operator+=(const Enclosure& a) { return *this = *this + a; }
  Enclosure& operator-=(const Enclosure& a) { return *this = *this - a; }

  // A difference that overflows is larger than the sum of the errors: |value| + error is finite for both.
  friend bool operator<(const Enclosure& a, const Enclosure& b) {
    return b.value_ - a.value_ > (a.error_ + b.error_) * (1 + 0x1p-49);
  }
  friend bool operator<=(const Enclosure& a, const Enclosure& b) {
    return b.value_ - a.value_ >= (a.error_ + b.error_) * (1 + 0x1p-49);
  }
  friend bool operator>(const Enclosure& a, const Enclosure& b) { return b < a; }
  friend bool operator>=(const Enclosure& a, const Enclosure& b) { return b <= a; }
  friend bool operator==(const Enclosure& a, const Enclosure& b) { return a <= b && b <= a; }

  // Not friends defined here: `checker::magnitude` has to find them as well.
  inline friend Enclosure magnitude(const Enclosure& a);
  inline friend Enclosure larger(const Enclosure& a, const Enclosure& b);
  /// A number that is at least the square root.
  friend Enclosure root_above(const Enclosure& a) {
    return Enclosure(std::sqrt(a.value_ + a.error_) * (1 + 0x1p-49) + 0x1p-500);
  }

 private:
  /// The only maker of values and errors that were computed: NaN, infinity and what overflows with its error
  /// become unknown.
  Enclosure(double value, double error) : value_(value), error_(error) {
    if (!(std::abs(value) + error <= std::numeric_limits<double>::max())) *this = unknown();
  }
  static Enclosure unknown() {
    Enclosure result;
    result.error_ = std::numeric_limits<double>::infinity();
    return result;
  }
  bool is_known() const { return error_ <= std::numeric_limits<double>::max(); }
  static Enclosure rounded(double value, double error) {
    return {value, (error + std::abs(value) * 0x1p-53) * (1 + 0x1p-49) + 0x1p-1000};
  }

  double value_;
  double error_ = 0;
};

/// |a|, which is within the same error of |value|.
inline Enclosure magnitude(const Enclosure& a) { return {std::abs(a.value_), a.error_}; }
inline Enclosure larger(const Enclosure& a, const Enclosure& b) {
  return {std::max(a.value_, b.value_), std::max(a.error_, b.error_)};
}

inline Rational half(const Rational& q) { return q / 2; }
inline double half(double a) { return a / 2; }
/// A double near the number, 0 if there is none: to look for numbers that are checked afterwards.
inline double approximate(const Rational& q) {
  const double near = to_double(q);
  return std::isfinite(near) ? near : 0;
}
inline double approximate(double a) { return a; }

/// A double that is at least the number; infinite beyond the doubles.
inline double above(const Rational& q) {
  return std::nextafter(to_double(q), std::numeric_limits<double>::infinity());
}
inline double above(const Enclosure& a) { return a.above(); }

}  // namespace exsect::checker
