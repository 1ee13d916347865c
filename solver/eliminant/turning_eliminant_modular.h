// The eliminant of the turning points at one u modulo one prime.
#pragma once

#include <exsect/algebra/modular.h>
#include <exsect/geometry/integer_pair.h>

#include <vector>

#include "eliminant/turning_eliminant_forms.h"

namespace exsect {

/// PrimeField as EliminantForms wants it.
class ScalarArithmetic {
 public:
  using Residue = exsect::Residue;
  class Sum {
   public:
    Sum() = default;
    Sum(Residue a, Residue b) : value_(static_cast<WideWord>(a) * b) {}
    void add(Residue a, Residue b) { value_ += static_cast<WideWord>(a) * b; }

   private:
    friend class ScalarArithmetic;
    WideWord value_ = 0;
  };

  explicit ScalarArithmetic(const PrimeField& field) : field_(field) {}

  const PrimeField& prime_field() const { return field_; }
  Residue reduce(const Sum& sum) const { return field_.reduce(sum.value_); }
  Residue reduce_few(const Sum& sum) const { return reduce(sum); }
  Residue add(Residue a, Residue b) const { return field_.add(a, b); }
  Residue add_unreduced(Residue a, Residue b) const { return field_.add(a, b); }
  Residue reduced(Residue a) const { return a; }
  Residue negate(Residue a) const { return field_.negate(a); }
  Residue multiply(Residue a, Residue b) const { return field_.multiply(a, b); }

 private:
  PrimeField field_;
};

/// Values of E(u) (docs/method.md, equation (4.8)) of a pair reduced modulo a prime.
class ModularEliminant {
 public:
  ModularEliminant(const PrimeField& field, const IntegerPair& pair);

  /// As EliminantForms::value, at first, first + 1, ..., first + count - 1.
  std::vector<ResidueFraction> fast_values(Residue first, std::size_t count) const;
  /// E(u) from resultants that allow any sequence of degrees: the denominator is zero only where
  /// g_s(u) Res(R,S1)(u) = 0. Several times slower.
  ResidueFraction value(Residue u) const;

 private:
  EliminantForms<ScalarArithmetic> forms_;
};

}  // namespace exsect
