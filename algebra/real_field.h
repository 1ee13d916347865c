// Real number fields Q(a), a an algebraic number: exact arithmetic, zero decided exactly, certified signs and
// enclosures.
#pragma once

#include <exsect/algebra/real_algebraic.h>

#include <memory>

namespace exsect {

/// The irreducible polynomial with the root a, primitive.
Polynomial minimal_polynomial(const RealAlgebraic& a);

/// The field Q(a). Copies share it, and numbers of the same field are those made with copies of one object.
class RealField {
 public:
  explicit RealField(const RealAlgebraic& a);

  int degree() const { return modulus().degree(); }
  /// a, known to some hundred bits.
  const RealAlgebraic& generator() const { return field_->generator; }
  /// The irreducible polynomial with the root a, and leading coefficient 1.
  const Polynomial& modulus() const { return field_->modulus; }
  friend bool operator==(const RealField& a, const RealField& b) { return a.field_ == b.field_; }

 private:
  struct Field {
    RealAlgebraic generator;
    Polynomial modulus;
  };
  std::shared_ptr<const Field> field_;
};

/// A rational number, or p(a) in a field Q(a), docs/method-doubles.md (14.70): always a polynomial of degree
/// below that of the field, so that it is rational, or zero, if and only if p is constant, or zero.
/// Operations throw std::invalid_argument if the operands are irrational numbers of different fields, and
/// std::domain_error for a division by zero.
class FieldNumber {
 public:
  FieldNumber() = default;
  FieldNumber(const Rational& q) : polynomial_(q) {}  // NOLINT: Q embeds
  FieldNumber(int n) : polynomial_(n) {}              // NOLINT
  /// p(a).
  FieldNumber(const RealField& field, const Polynomial& p);

  bool is_zero() const { return polynomial_.is_zero(); }
  bool is_rational() const { return polynomial_.degree() <= 0; }
  /// Requires is_rational(), else std::domain_error.
  Rational rational() const;
  /// p.
  const Polynomial& polynomial() const { return polynomial_; }

  FieldNumber operator-() const;
  FieldNumber& operator+=(const FieldNumber& b);
  FieldNumber& operator-=(const FieldNumber& b);
  FieldNumber& operator*=(const FieldNumber& b);
  FieldNumber& operator/=(const FieldNumber& b);
  friend FieldNumber operator+(FieldNumber a, const FieldNumber& b) { return a += b; }
  friend FieldNumber operator-(FieldNumber a, const FieldNumber& b) { return a -= b; }
  friend FieldNumber operator*(FieldNumber a, const FieldNumber& b) { return a *= b; }
  friend FieldNumber operator/(FieldNumber a, const FieldNumber& b) { return a /= b; }
  friend bool operator==(const FieldNumber& a, const FieldNumber& b) { return (a - b).is_zero(); }

  /// A closed interval with the number inside, of width at most 2^-bits times its size; both ends are the
  /// number itself if it is rational. Requires bits >= 0.
  friend RationalInterval enclosure(const FieldNumber& a, long bits);

 private:
  void join(const FieldNumber& b);

  std::shared_ptr<const RealField> field_;  // of an irrational number, and perhaps of others
  Polynomial polynomial_;
};

/// -1, 0, +1.
int sign(const FieldNumber& a);
/// Within 2^-53 (1 + 2^-8) of the number, relative to it, above the subnormal doubles; infinite beyond all.
double to_double(const FieldNumber& a);

}  // namespace exsect
