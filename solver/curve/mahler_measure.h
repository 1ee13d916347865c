// Rigorous bounds of logarithms and of the Mahler measure of integer polynomials.
#pragma once

#include <exsect/algebra/rational.h>

#include <optional>
#include <vector>

namespace exsect {

/// 2^exponent mantissa with 1/2 <= |mantissa| < 1, or zero.
struct ScaledDouble {
  double mantissa;
  long exponent;
};
/// Truncated towards zero to 53 bits.
ScaledDouble scaled_double(const Integer& a);

/// At least log2 x and at most 0.0862 more; requires x > 0 and normal.
double log2_upper(double x);
/// The same for |a|; requires a != 0.
double log2_upper(const Integer& a);
/// At most log2 |a| and at least 0.0862 less; requires a != 0.
double log2_lower(const Integer& a);

/// A lower bound of m(f), the mean of log2 |f| over the unit circle, or nothing for f = 0. Coefficients
/// constant term first.
std::optional<double> measure_lower(std::vector<Integer> coefficients);
/// At least log2 of the 2-norm of the vector, which must not be zero. (For the coefficients of a polynomial
/// in one or several variables this is an upper bound of m(f): Jensen's inequality and Parseval's identity.)
double log2_norm_upper(const std::vector<Integer>& coefficients);

}  // namespace exsect
