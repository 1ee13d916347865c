// The parameter of a line at one of its points on the other patch.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/algebra/triangular_point.h>

#include <optional>

namespace exsect {

/// A real algebraic number t, or the quotient of two polynomials at a point of the other patch, which becomes
/// a number by itself only when that is asked for: its own polynomial may be long.
class LineParameter {
 public:
  LineParameter(RealAlgebraic t) : number_(std::move(t)) {}  // NOLINT: a number
  /// A quotient that is a rational number of at most about 30 bits is known to be one. Throws
  /// std::invalid_argument if the denominator is zero at the point.
  LineParameter(BivariatePolynomial numerator, BivariatePolynomial denominator, TriangularPoint at);

  /// A closed interval that contains t, of width at most `width` > 0.
  RationalInterval enclosure(const Rational& width) const;
  /// Exact sign of t - value.
  int compare(const Rational& value) const;
  /// Empty in the rare case of quotient_at (algebra/algebraic_value.h).
  std::optional<RealAlgebraic> number() const;

 private:
  struct Quotient {
    BivariatePolynomial numerator;
    BivariatePolynomial denominator;
    TriangularPoint at;
    int sign;  // of the denominator
  };
  std::optional<RealAlgebraic> number_;
  std::optional<Quotient> quotient_;
};

}  // namespace exsect
