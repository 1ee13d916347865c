// Quadratic interval refinement: the isolating interval of a simple root shrinks on dyadic grids, the number
// of correct bits doubling from step to step; every interval is proved by the signs at its ends. Not a public
// header.
#pragma once

#include "fixed_point_horner.h"
#include "flint.h"
#include "polynomial.h"

namespace exsect {

/// A ball that contains the closed interval; its ends are rounded to `precision` bits.
void set_ball(arb_t ball, const RationalInterval& interval, slong precision);

/// numerator / 2^exponent.
Rational dyadic(const fmpz_t numerator, slong exponent);

/// The least e with 2^-e <= width; requires width > 0.
slong grid_exponent(const Rational& width);

/// A real function at dyadic points.
class DyadicFunction {
 public:
  DyadicFunction() = default;
  virtual ~DyadicFunction() = default;
  DyadicFunction(const DyadicFunction&) = delete;
  DyadicFunction& operator=(const DyadicFunction&) = delete;

  /// Sets `value` to a ball that contains the value at numerator / 2^exponent: exactly 0 if the function
  /// vanishes there, else a ball without 0. `accuracy` relative bits are wanted, for speed; nothing depends
  /// on them.
  virtual void evaluate(arb_t value, const fmpz_t numerator, slong exponent, slong accuracy) = 0;
};

/// A nonzero polynomial up to a positive factor: in fixed point with ever more limbs until the sign is
/// certain, exact at last. The polynomial must outlive it; the points lie in `domain`.
class DyadicPolynomial : public DyadicFunction {
 public:
  DyadicPolynomial(const Polynomial& f, const RationalInterval& domain);
  void evaluate(arb_t value, const fmpz_t numerator, slong exponent, slong accuracy) override;

 private:
  void evaluate_exactly(arb_t value, const fmpz_t numerator, slong exponent) const;

  const fmpz* coefficients_;
  slong degree_;
  FixedPointHorner horner_;
  slong loss_ = 0;           // leading zero bits of the last value in fixed point
  slong loss_exponent_ = 0;  // the exponent it was made at
};

/// Requires: f is continuous with exactly one root in the open interval, and has the nonzero signs
/// `sign_lower` and -sign_lower at its ends. Returns an interval inside it with the same properties and width
/// at most `width` > 0, or both ends equal to the root. An interval that is narrow enough already is returned
/// unchanged.
RationalInterval refine(DyadicFunction& f, const RationalInterval& isolating, int sign_lower,
                        const Rational& width);

}  // namespace exsect
