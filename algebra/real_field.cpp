#include "real_field.h"

#include <algorithm>
#include <stdexcept>

#include "flint_polynomial.h"
#include "number_field.h"
#include "quadratic_refinement.h"

namespace exsect {

namespace {

constexpr long kGeneratorBits = 256;
constexpr long kGuardBits = 64;
constexpr long kRoundingBits = 62;

/// An interval with f(a) inside.
RationalInterval value_on(const Polynomial& f, const RationalInterval& a, slong precision) {
  FlintBall point, value;
  set_ball(point.value, a, precision);
  const fmpq_poly_struct* polynomial = f.rep().value;
  for (int i = f.degree(); i >= 0; --i) {
    arb_mul(value.value, value.value, point.value, precision);
    arb_add_fmpz(value.value, value.value, polynomial->coeffs + i, precision);
  }
  arb_div_fmpz(value.value, value.value, fmpq_poly_denref(f.rep().value), precision);
  arf_t end;
  arf_init(end);
  arb_get_lbound_arf(end, value.value, precision);
  RationalInterval result{to_rational(end), 0};
  arb_get_ubound_arf(end, value.value, precision);
  result.upper = to_rational(end);
  arf_clear(end);
  return result;
}

Polynomial monic(const Polynomial& f) { return f * Polynomial(Rational(1 / f.leading_coefficient())); }

}  // namespace

Polynomial minimal_polynomial(const RealAlgebraic& a) {
  if (a.is_rational()) return Polynomial({-Rational(numerator(a.rational())), denominator(a.rational())});
  for (const PolynomialPower& power : irreducible_factors(a.polynomial()))
    if (sign_at(power.factor, a) == 0) return power.factor;
  throw std::logic_error("minimal_polynomial: no factor vanishes at the number");
}

RealField::RealField(const RealAlgebraic& a)
    : field_(std::make_shared<const Field>(
          Field{a.refined_to(power_of_two(-kGeneratorBits)), monic(minimal_polynomial(a))})) {}

FieldNumber::FieldNumber(const RealField& field, const Polynomial& p)
    : field_(std::make_shared<const RealField>(field)), polynomial_(divide(p, field.modulus()).remainder) {}

Rational FieldNumber::rational() const {
  if (!is_rational()) throw std::domain_error("FieldNumber::rational: the number is irrational");
  return polynomial_.coefficient(0);
}

void FieldNumber::join(const FieldNumber& b) {
  if (!b.field_ || field_ == b.field_) return;
  if (is_rational())
    field_ = b.field_;
  else if (!b.is_rational() && !(*field_ == *b.field_))
    throw std::invalid_argument("FieldNumber: the numbers belong to different fields");
}

FieldNumber FieldNumber::operator-() const {
  FieldNumber result = *this;
  result.polynomial_ = -polynomial_;
  return result;
}

FieldNumber& FieldNumber::operator+=(const FieldNumber& b) {
  join(b);
  polynomial_ += b.polynomial_;
  return *this;
}

FieldNumber& FieldNumber::operator-=(const FieldNumber& b) {
  join(b);
  polynomial_ -= b.polynomial_;
  return *this;
}

FieldNumber& FieldNumber::operator*=(const FieldNumber& b) {
  join(b);
  polynomial_ *= b.polynomial_;
  if (field_ && polynomial_.degree() >= field_->degree())
    polynomial_ = divide(polynomial_, field_->modulus()).remainder;
  return *this;
}

FieldNumber& FieldNumber::operator/=(const FieldNumber& b) {
  if (b.is_zero()) throw std::domain_error("FieldNumber: division by zero");
  FieldNumber inverse = b;
  // The modulus is irreducible, so that every number but zero has an inverse.
  inverse.polynomial_ = b.is_rational() ? Polynomial(Rational(1 / b.rational()))
                                        : *inverse_modulo(b.polynomial_, b.field_->modulus());
  return *this *= inverse;
}

// An irrational number is not zero, so that the interval becomes as narrow as is asked for.
RationalInterval enclosure(const FieldNumber& a, long bits) {
  if (a.is_rational()) return {a.rational(), a.rational()};
  for (long precision = std::max(kGeneratorBits, bits + kGuardBits);; precision *= 2) {
    const RealAlgebraic root = a.field_->generator().refined_to(power_of_two(-precision));
    RationalInterval value =
        value_on(a.polynomial_, root.interval(), static_cast<slong>(precision + kGuardBits));
    const Rational least = value.lower > 0 ? value.lower : Rational(-value.upper);
    if (least > 0 && value.width() <= power_of_two(-bits) * least) return value;
  }
}

int sign(const FieldNumber& a) { return a.is_rational() ? sign(a.rational()) : sign(enclosure(a, 0).lower); }

double to_double(const FieldNumber& a) { return to_double(enclosure(a, kRoundingBits).midpoint()); }

}  // namespace exsect
