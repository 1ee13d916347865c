// Enclosures of real numbers: balls whose midpoints have 256 bits, without memory of their own.
#pragma once

#include <exsect/algebra/floating_point.h>
#include <exsect/algebra/modular.h>
#include <exsect/algebra/rational.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace exsect {

/// The reals x with |x - m| <= rad. The midpoint m is zero or ± n 2^(exponent-256), n of exactly 256 bits.
/// Some five times as fast as ArbBall of that precision.
///
/// `magnitude` >= |m| and the radius are doubles, at least 2^-1000 where they are not exactly zero; after
/// overflow they are infinite or NaN, and every predicate is false. A sum is kept in units of
/// 2^(exponent-256) of its largest term so far; each term loses at most 4 units in the product and 1 when it
/// is aligned, and everything before it at most 1 when the exponent grows. The thread rounds to nearest
/// (nearest_rounding.h).
class WideBall {
 public:
  WideBall() = default;
  /// Exactly x, which is finite.
  WideBall(double x);  // NOLINT: doubles are balls of radius 0
  /// A ball around n 2^exponent of relative radius at most 2^-255.
  static WideBall enclosing(const Integer& n, long exponent);
  /// The smallest convenient ball containing the closed interval.
  static WideBall enclosing(const RationalInterval& interval);

  WideBall midpoint() const { return {limbs_, exponent_, negative_, magnitude_, 0}; }
  /// The same midpoint, radius enlarged by r >= 0.
  WideBall widened(double r) const {
    return {limbs_, exponent_, negative_, magnitude_, (radius_ + r) * (1 + 0x1p-50)};
  }
  /// The midpoint up to 2^-49 of it, if that is in the range of doubles.
  double approximation() const { return negative_ ? -magnitude_ : magnitude_; }
  /// Upper bound of the radius.
  double radius() const { return radius_; }
  /// Upper bound of |m|.
  double magnitude() const { return magnitude_; }
  /// Lower bound of |x| over the ball, 0 if it may contain 0.
  double lower_magnitude() const {
    // A midpoint below 2^-936 has this magnitude.
    if (!(magnitude_ > 0x1p-930 && magnitude_ < std::numeric_limits<double>::infinity())) return 0;
    const double gap = magnitude_ * (1 - 0x1p-50) - radius_ * (1 + 0x1p-50);
    return gap > 0 ? gap : 0;
  }
  /// +1 or -1 if every member has that sign, else 0: "not known".
  int certain_sign() const { return lower_magnitude() > 0 ? (negative_ ? -1 : 1) : 0; }
  RationalInterval interval() const;

  WideBall operator-() const { return {limbs_, exponent_, !negative_, magnitude_, radius_}; }
  friend WideBall operator+(const WideBall& a, const WideBall& b);
  friend WideBall operator-(const WideBall& a, const WideBall& b) { return a + -b; }
  friend WideBall operator*(const WideBall& a, const WideBall& b);
  /// 1/a; infinite radius if a may contain zero.
  friend WideBall inverse(const WideBall& a);
  /// a 2^k, exactly.
  friend WideBall scaled(const WideBall& a, int k);

  /// A sum of at most 2^20 terms, rounded once.
  class Sum;

 private:
  static constexpr std::size_t kLimbs = 4;
  using Limbs = std::array<std::uint64_t, kLimbs>;  // the least significant first

  WideBall(const Limbs& limbs, std::int64_t exponent, bool negative, double magnitude, double radius)
      : limbs_(limbs), exponent_(exponent), negative_(negative), magnitude_(magnitude), radius_(radius) {}

  void set_magnitude() {
    magnitude_ = static_cast<double>(limbs_[kLimbs - 1]) * (1 + 0x1p-51) * power(exponent_ - 64);
  }
  bool is_zero() const { return limbs_[kLimbs - 1] == 0; }

  /// At least 2^k, 2^-1000 at least; infinite for large k.
  static double power(std::int64_t k) {
    if (k > 1000) return std::numeric_limits<double>::infinity();
    return std::bit_cast<double>(static_cast<std::uint64_t>(std::max<std::int64_t>(k, -1000) + 1023) << 52);
  }

  Limbs limbs_ = {};
  std::int64_t exponent_ = 0;
  bool negative_ = false;
  double magnitude_ = 0;
  double radius_ = 0;
};

class WideBall::Sum {
 public:
  Sum() = default;
  Sum(const WideBall& a, const WideBall& b) { add(a, b); }

  void add(const WideBall& a) {
    radius_ += a.radius_;
    if (!a.is_zero()) add({a.limbs_[0], a.limbs_[1], a.limbs_[2], a.limbs_[3], a.exponent_, a.negative_});
  }
  /// Adds a b.
  void add(const WideBall& a, const WideBall& b) {
    radius_ += a.magnitude_ * b.radius_ + a.radius_ * (b.magnitude_ + b.radius_);
    if (!a.is_zero() && !b.is_zero()) add(product(a, b));
  }
  WideBall rounded() const;

 private:
  /// ± n 2^(exponent-256).
  struct Term {
    std::uint64_t n0, n1, n2, n3;  // limbs of n, the least significant first
    std::int64_t exponent;
    bool negative;
  };

  /// The product of two midpoints less at most 4 units: three products of limbs of index sum 2, of less than
  /// 2^-64 units each with what is below them, and the last digit are left out.
  static Term product(const WideBall& x, const WideBall& y) {
    std::uint64_t carry = 0;
    const auto step = [&](std::size_t i, std::size_t j, std::uint64_t& digit) {
      const WideWord w = static_cast<WideWord>(x.limbs_[i]) * y.limbs_[j] + digit + carry;
      digit = static_cast<std::uint64_t>(w);
      carry = static_cast<std::uint64_t>(w >> 64);
    };
    const auto end_row = [&](std::uint64_t& digit) {
      digit = carry;
      carry = 0;
    };
    Term result = {};
    std::uint64_t below = 0;
    step(0, 3, below);
    end_row(result.n0);
    step(1, 2, below);
    step(1, 3, result.n0);
    end_row(result.n1);
    step(2, 1, below);
    step(2, 2, result.n0);
    step(2, 3, result.n1);
    end_row(result.n2);
    step(3, 0, below);
    step(3, 1, result.n0);
    step(3, 2, result.n1);
    step(3, 3, result.n2);
    end_row(result.n3);
    result.exponent = x.exponent_ + y.exponent_;
    result.negative = x.negative_ != y.negative_;
    return result;
  }

  void add(Term term) {
    if (terms_ == 0) exponent_ = term.exponent;
    ++terms_;
    const std::int64_t by = exponent_ - term.exponent;
    if (by != 0) align(term, by);
    const std::uint64_t mask = term.negative ? ~std::uint64_t{0} : 0;
    bool carry = term.negative;
    const auto step = [&](std::uint64_t& digit, std::uint64_t n) {
      std::uint64_t sum;
      const bool first = __builtin_add_overflow(digit, n ^ mask, &sum);
      const bool second = __builtin_add_overflow(sum, static_cast<std::uint64_t>(carry), &digit);
      carry = first || second;
    };
    step(n0_, term.n0);
    step(n1_, term.n1);
    step(n2_, term.n2);
    step(n3_, term.n3);
    top_ += mask + static_cast<std::uint64_t>(carry);
  }

  /// The term, or the sum so far where by < 0, in units of the other.
  void align(Term& term, std::int64_t by) {
    if (by > 0 && by < 64) {
      term.n0 = joined(term.n0, term.n1, by);
      term.n1 = joined(term.n1, term.n2, by);
      term.n2 = joined(term.n2, term.n3, by);
      term.n3 >>= by;
    } else {
      align_far(term, by);
    }
  }
  static std::uint64_t joined(std::uint64_t low, std::uint64_t high, std::int64_t by) {  // 0 < by < 64
    return (low >> by) | (high << (64 - by));
  }
  void align_far(Term& term, std::int64_t by);

  std::uint64_t n0_ = 0, n1_ = 0, n2_ = 0, n3_ = 0;
  std::uint64_t top_ = 0;  // the most significant limb of a two's complement number of 320 bits
  std::int64_t exponent_ = 0;
  int terms_ = 0;
  double radius_ = 0;
};

inline WideBall operator+(const WideBall& a, const WideBall& b) {
  WideBall::Sum sum;
  sum.add(a);
  sum.add(b);
  return sum.rounded();
}
inline WideBall operator*(const WideBall& a, const WideBall& b) { return WideBall::Sum(a, b).rounded(); }

}  // namespace exsect
