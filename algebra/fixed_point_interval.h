// Outward-rounded interval arithmetic on integers with a fixed binary point, at any precision.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <vector>

namespace exsect {

/// The closed interval [lower, upper] 2^-bits, lower <= upper integers. Every operation returns an interval
/// with the same number of bits that contains all exact results on members of the operands. Operands of one
/// operation must have the same number of bits.
class FixedPointInterval {
 public:
  /// Smallest such interval containing [x.lower, x.upper].
  FixedPointInterval(const RationalInterval& x, long bits);
  FixedPointInterval(const Integer& x, long bits);

  long bits() const { return bits_; }
  bool contains_zero() const { return lower_ <= 0 && upper_ >= 0; }
  RationalInterval interval() const;

  friend FixedPointInterval operator+(const FixedPointInterval& a, const FixedPointInterval& b);
  friend FixedPointInterval operator-(const FixedPointInterval& a, const FixedPointInterval& b);
  friend FixedPointInterval operator*(const FixedPointInterval& a, const FixedPointInterval& b);
  /// Throws std::domain_error if b contains zero.
  friend FixedPointInterval operator/(const FixedPointInterval& a, const FixedPointInterval& b);
  FixedPointInterval operator-() const;
  /// Square roots of the nonnegative members; throws std::domain_error if there are none.
  friend FixedPointInterval sqrt(const FixedPointInterval& a);

 private:
  FixedPointInterval(Integer lower, Integer upper, long bits)
      : lower_(std::move(lower)), upper_(std::move(upper)), bits_(bits) {}
  Integer lower_;
  Integer upper_;
  long bits_;
};

/// A polynomial with integer coefficients over a positive common denominator, ready for interval evaluation.
struct IntegerPolynomial {
  explicit IntegerPolynomial(const Polynomial& f);

  std::vector<Integer> numerators;  // constant term first
  Integer denominator;
};

/// The polynomial with these coefficients, constant term first; trailing zeros allowed.
Polynomial polynomial_of(const std::vector<Integer>& coefficients);

/// Encloses numerators(t), the denominator left out (Horner).
FixedPointInterval enclose_numerator(const IntegerPolynomial& f, const FixedPointInterval& t);
/// Encloses f over the box.
FixedPointInterval enclose(const BivariatePolynomial& f, const FixedPointInterval& r,
                           const FixedPointInterval& s);

/// The shortest interval with ends in 2^-k Z, 2^-k <= width/4, that contains x: at most width/2 wider.
RationalInterval rounded_outward(const RationalInterval& x, const Rational& width);
/// Least k >= 0 with 2^-k <= width; requires width > 0, else std::invalid_argument.
long bits_below(const Rational& width);

}  // namespace exsect
