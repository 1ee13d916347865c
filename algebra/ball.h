// Enclosures of real numbers: midpoint-radius balls in doubles, and in Arb at a fixed number of bits.
//
// Both classes offer the same operations, so that an algorithm written once as a template runs in doubles
// first and in Arb where doubles run out. A ball contains every value that the exact operation takes on the
// operands' members.
#pragma once

#include <exsect/algebra/floating_point.h>
#include <exsect/algebra/rational.h>

#include <cmath>
#include <limits>

namespace exsect {

/// The reals x with |x - mid| <= rad. rad may be infinite or NaN (after overflow): every predicate is then
/// false.
///
/// Rounding, u = 2^-53, eta = 2^-1074: a sum or difference m of two doubles has error <= u|m|, a product <=
/// u|m| + eta (IEEE 754, round to nearest, no contraction). A radius is a sum of at most six nonnegative
/// terms, each a product of at most two rounded factors, so its computed value is at least (1 - 2^-49) times
/// the true one apart from underflow; `up` multiplies by 1 + 2^-48 and adds 2^-1000, which covers both and
/// every eta above. The thread rounds to nearest (nearest_rounding.h).
class DoubleBall {
 public:
  DoubleBall() : mid_(0), rad_(0) {}
  /// Exactly x.
  DoubleBall(double x) : mid_(x), rad_(0) {}  // NOLINT: doubles are balls of radius 0
  DoubleBall(double mid, double rad) : mid_(mid), rad_(rad) {}
  /// A ball around q of relative radius at most 2^-52.
  static DoubleBall enclosing(const Rational& q);
  /// The smallest convenient ball containing the closed interval.
  static DoubleBall enclosing(const RationalInterval& interval);
  /// The same of an interval between doubles; of infinite or NaN radius if one of them is no finite number.
  static DoubleBall between(double lower, double upper);

  /// The midpoint as a ball of radius 0.
  DoubleBall midpoint() const { return mid_; }
  /// The same midpoint, radius enlarged by r >= 0.
  DoubleBall widened(double r) const { return {mid_, up(rad_ + r)}; }
  double approximation() const { return mid_; }
  /// Upper bound of the radius.
  double radius() const { return rad_; }
  /// Upper bound of |x| over the ball.
  double upper_magnitude() const { return up(std::fabs(mid_) + rad_); }
  /// Lower bound of |x| over the ball, 0 if it may contain 0.
  double lower_magnitude() const {
    const double gap = std::fabs(mid_) * (1 - 0x1p-50) - rad_ * (1 + 0x1p-50);
    return gap > 0 ? gap : 0;
  }
  bool is_positive() const { return mid_ > rad_; }
  bool is_negative() const { return -mid_ > rad_; }
  /// +1 or -1 if every member has that sign, else 0: "not known".
  int certain_sign() const { return is_positive() ? 1 : is_negative() ? -1 : 0; }
  RationalInterval interval() const;

  DoubleBall operator-() const { return {-mid_, rad_}; }
  friend DoubleBall operator+(const DoubleBall& a, const DoubleBall& b) {
    const double m = a.mid_ + b.mid_;
    return {m, up(a.rad_ + b.rad_ + std::fabs(m) * 0x1p-53)};
  }
  friend DoubleBall operator-(const DoubleBall& a, const DoubleBall& b) {
    const double m = a.mid_ - b.mid_;
    return {m, up(a.rad_ + b.rad_ + std::fabs(m) * 0x1p-53)};
  }
  friend DoubleBall operator*(const DoubleBall& a, const DoubleBall& b) {
    const double m = a.mid_ * b.mid_;
    return {m, up(std::fabs(a.mid_) * b.rad_ + a.rad_ * std::fabs(b.mid_) + a.rad_ * b.rad_ +
                  std::fabs(m) * 0x1p-53)};
  }
  DoubleBall& operator+=(const DoubleBall& b) { return *this = *this + b; }
  DoubleBall& operator-=(const DoubleBall& b) { return *this = *this - b; }
  DoubleBall& operator*=(const DoubleBall& b) { return *this = *this * b; }

 private:
  static double up(double r) { return r * (1 + 0x1p-48) + 0x1p-1000; }
  double mid_;
  double rad_;
};

/// The smallest convenient ball around both; of infinite or NaN radius if one of theirs is.
DoubleBall hull(const DoubleBall& a, const DoubleBall& b);

namespace detail {

/// Inline storage of one arb_t; every operation is defined in ball.cpp, so that no FLINT header is needed
/// here.
class ArbStorage {
 public:
  ArbStorage();
  explicit ArbStorage(double x);
  ArbStorage(const ArbStorage& other);
  ArbStorage(ArbStorage&& other) noexcept;
  ArbStorage& operator=(const ArbStorage& other);
  ArbStorage& operator=(ArbStorage&& other) noexcept;
  ~ArbStorage();

  void set_interval(const Rational& lower, const Rational& upper, long bits);
  void set_midpoint_of(const ArbStorage& a);
  void widen(double r);
  void negate();
  void add(const ArbStorage& a, const ArbStorage& b, long bits);
  void subtract(const ArbStorage& a, const ArbStorage& b, long bits);
  void multiply(const ArbStorage& a, const ArbStorage& b, long bits);
  void add_product(const ArbStorage& a, const ArbStorage& b, long bits);
  double approximation() const;
  double radius() const;
  double upper_magnitude() const;
  double lower_magnitude() const;
  int certain_sign() const;
  RationalInterval interval() const;

 private:
  alignas(8) unsigned char bytes_[48];
};

}  // namespace detail

/// A ball of Arb with midpoints rounded to `Bits` bits; the operations of DoubleBall.
template <long Bits>
class ArbBall {
 public:
  ArbBall() = default;
  ArbBall(double x) : value_(x) {}  // NOLINT: doubles are balls of radius 0
  ArbBall(double mid, double rad) : value_(mid) { value_.widen(rad); }
  static ArbBall enclosing(const Rational& q) { return enclosing(RationalInterval{q, q}); }
  static ArbBall enclosing(const RationalInterval& interval) {
    ArbBall result;
    result.value_.set_interval(interval.lower, interval.upper, Bits);
    return result;
  }

  ArbBall midpoint() const {
    ArbBall result;
    result.value_.set_midpoint_of(value_);
    return result;
  }
  ArbBall widened(double r) const {
    ArbBall result = *this;
    result.value_.widen(r);
    return result;
  }
  double approximation() const { return value_.approximation(); }
  double radius() const { return value_.radius(); }
  double upper_magnitude() const { return value_.upper_magnitude(); }
  double lower_magnitude() const { return value_.lower_magnitude(); }
  bool is_positive() const { return value_.certain_sign() > 0; }
  bool is_negative() const { return value_.certain_sign() < 0; }
  int certain_sign() const { return value_.certain_sign(); }
  RationalInterval interval() const { return value_.interval(); }

  ArbBall operator-() const {
    ArbBall result = *this;
    result.value_.negate();
    return result;
  }
  friend ArbBall operator+(const ArbBall& a, const ArbBall& b) {
    ArbBall result;
    result.value_.add(a.value_, b.value_, Bits);
    return result;
  }
  friend ArbBall operator-(const ArbBall& a, const ArbBall& b) {
    ArbBall result;
    result.value_.subtract(a.value_, b.value_, Bits);
    return result;
  }
  friend ArbBall operator*(const ArbBall& a, const ArbBall& b) {
    ArbBall result;
    result.value_.multiply(a.value_, b.value_, Bits);
    return result;
  }
  ArbBall& operator+=(const ArbBall& b) {
    value_.add(value_, b.value_, Bits);
    return *this;
  }
  ArbBall& operator-=(const ArbBall& b) {
    value_.subtract(value_, b.value_, Bits);
    return *this;
  }
  ArbBall& operator*=(const ArbBall& b) {
    value_.multiply(value_, b.value_, Bits);
    return *this;
  }
  friend void add_product(ArbBall& sum, const ArbBall& a, const ArbBall& b) {
    sum.value_.add_product(a.value_, b.value_, Bits);
  }

 private:
  detail::ArbStorage value_;
};

/// sum += a b.
template <class Number>
void add_product(Number& sum, const Number& a, const Number& b) {
  sum += a * b;
}

}  // namespace exsect
