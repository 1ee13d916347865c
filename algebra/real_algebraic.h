// Real algebraic numbers: exact comparison, exact signs of polynomials, refinement to any width.
#pragma once

#include <exsect/algebra/polynomial.h>

#include <compare>
#include <memory>
#include <vector>

namespace exsect {

/// Either a rational number, or the one root of a squarefree primitive polynomial in an open interval at
/// whose rational ends that polynomial has opposite nonzero signs. Immutable: `refined_to` returns a new
/// value.
class RealAlgebraic {
 public:
  RealAlgebraic(const Rational& value);                         // NOLINT: Q embeds
  RealAlgebraic(int value) : RealAlgebraic(Rational(value)) {}  // NOLINT

  /// The root of `f` in (lower, upper). Throws std::invalid_argument unless f has opposite nonzero signs at
  /// the ends. The caller promises that f is squarefree with exactly one root there (isolate_roots proves
  /// it).
  static RealAlgebraic root_of(const Polynomial& f, const RationalInterval& isolating);

  bool is_rational() const { return lower_ == upper_; }
  /// Requires is_rational(), else std::domain_error.
  const Rational& rational() const;
  /// A squarefree primitive polynomial that vanishes here; linear if the number is known to be rational.
  const Polynomial& polynomial() const { return *polynomial_; }
  /// Open interval around the number; both ends equal it if is_rational().
  RationalInterval interval() const { return {lower_, upper_}; }

  /// The same number with an interval of width at most `width`, inside the present one; quadratically
  /// convergent. The root itself is returned if it is met on the way. Throws std::invalid_argument unless
  /// width > 0.
  RealAlgebraic refined_to(const Rational& width) const;
  /// Within one unit in the last place of the number; infinite beyond the range of doubles.
  double to_double() const;
  /// -1, 0, +1: sign of (this - q).
  int compare(const Rational& q) const;

  /// Exact: equality is decided by gcd, order by refinement afterwards.
  friend std::strong_ordering operator<=>(const RealAlgebraic& a, const RealAlgebraic& b);
  friend bool operator==(const RealAlgebraic& a, const RealAlgebraic& b) {
    return (a <=> b) == std::strong_ordering::equal;
  }

 private:
  RealAlgebraic(std::shared_ptr<const Polynomial> polynomial, RationalInterval interval, int sign_lower);
  friend std::vector<RealAlgebraic> real_roots(const Polynomial& f, const Rational& a, const Rational& b);

  std::shared_ptr<const Polynomial> polynomial_;  // shared between the roots of one polynomial
  Rational lower_;
  Rational upper_;
  int sign_lower_;  // of the polynomial at lower_; 0 if rational
};

/// Exact sign of f at alpha: -1, 0, +1. A ball evaluation decides first; zero is decided by gcd.
int sign_at(const Polynomial& f, const RealAlgebraic& alpha);

/// Distinct real roots of f in the closed interval [a,b], ascending, all of one polynomial: the squarefree
/// part of f, except those found to be rational. f need not be squarefree. Throws std::domain_error for f =
/// 0, std::invalid_argument for a > b.
std::vector<RealAlgebraic> real_roots(const Polynomial& f, const Rational& a, const Rational& b);

}  // namespace exsect
