// Numbers of the form a + b sqrt(c): real algebraic numbers whose order and signs are known independently.
#pragma once

#include <exsect/algebra/real_algebraic.h>

#include <stdexcept>
#include <vector>

#include "algebra/random_numbers.h"

namespace exsect::test {

inline int sign_of(std::strong_ordering o) { return o < 0 ? -1 : o > 0 ? 1 : 0; }

/// a + b sqrt(c), c >= 0.
struct QuadraticNumber {
  Rational a, b, c;

  /// (t - a)^2 - b^2 c
  Polynomial polynomial() const {
    const Polynomial t = linear_factor(a);
    return t * t - Polynomial(b * b * c);
  }

  /// An interval around the number without its conjugate, sqrt(c) enclosed to 2^-bits; requires b != 0, c >
  /// 0.
  RationalInterval enclosure(unsigned bits) const {
    const Integer scaled = (numerator(c) << (2 * bits)) / denominator(c);
    const Integer root = sqrt(scaled);
    const Rational low = a + b * Rational(root, Integer(1) << bits);
    const Rational high = a + b * Rational(root + 1, Integer(1) << bits);
    const Rational slack = abs(b) * power_of_two(-static_cast<long>(bits));
    return low < high ? RationalInterval{low - slack, high + slack}
                      : RationalInterval{high - slack, low + slack};
  }

  /// The number as a root of `multiple` times its polynomial.
  RealAlgebraic number(const Polynomial& multiple = 1, unsigned bits = 40) const {
    return RealAlgebraic::root_of(multiple * polynomial(), enclosure(bits));
  }
};

/// The sign of A + B sqrt(c) + C sqrt(d), c, d >= 0, by squaring twice.
inline int sign_of_sum(const Rational& A, const Rational& B, const Rational& c, const Rational& C,
                       const Rational& d) {
  const auto two_terms = [](const Rational& x, const Rational& y, const Rational& e) {
    const Rational root_part = y * y * e;
    if (sign(x) * sign(y) * sign(e) >= 0) return sign(x) != 0 ? sign(x) : sign(y) * sign(e);
    return x * x > root_part ? sign(x) : x * x < root_part ? sign(y) : 0;
  };
  const int first = two_terms(A, B, c);
  const int second = sign(C) * sign(d);
  if (first * second >= 0) return first != 0 ? first : second;
  const int larger = two_terms(A * A + B * B * c - C * C * d, 2 * A * B, c);
  return larger > 0 ? first : larger < 0 ? second : 0;
}

/// The sign of x - y.
inline int compare(const QuadraticNumber& x, const QuadraticNumber& y) {
  return sign_of_sum(x.a - y.a, x.b, x.c, -y.b, y.c);
}

/// f(a + b sqrt(c)) = result.a + result.b sqrt(c), by Horner's rule in Q(sqrt c).
inline QuadraticNumber value_at(const Polynomial& f, const QuadraticNumber& x) {
  QuadraticNumber value{0, 0, x.c};
  for (int i = f.degree(); i >= 0; --i) {
    const Rational a = value.a * x.a + value.b * x.b * x.c + f.coefficient(i);
    value.b = value.a * x.b + value.b * x.a;
    value.a = a;
  }
  return value;
}

}  // namespace exsect::test
