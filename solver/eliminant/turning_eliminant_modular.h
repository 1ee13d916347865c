// The eliminant of the turning points at one u modulo one prime.
#pragma once

#include <exsect/algebra/modular.h>
#include <exsect/geometry/integer_pair.h>

#include <vector>

#include "eliminant/stripped_eliminant_forms.h"
#include "eliminant/turning_eliminant_forms.h"
#include "eliminant/weighted_pair.h"

namespace exsect {

/// f' of f, constant terms first.
std::vector<Residue> derivative(const PrimeField& field, const std::vector<Residue>& f);

/// PrimeField as FibreResultants wants it.
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

/// Values of E(u) (docs/method.md, equations (4.8), (16.9), (16.16) and (16.20)) of a pair reduced modulo a
/// prime.
template <class Forms>
class ModularEliminantOf {
 public:
  template <class Pair>
  ModularEliminantOf(const PrimeField& field, const Pair& pair);

  /// As FibreResultants::value, at first, first + 1, ..., first + count - 1.
  std::vector<ResidueFraction> fast_values(Residue first, std::size_t count) const;
  /// E(u) from resultants that allow any sequence of degrees: the denominator is zero only where
  /// g_s(u) Res(R,S1)(u) = 0, or l_s Res(R,S1) = 0. Several times slower.
  ResidueFraction value(Residue u) const;
  /// E at `count` successive u from `first`, by the slower way where the faster one is not defined.
  std::vector<ResidueFraction> values(Residue first, std::size_t count) const;

 private:
  Forms forms_;
};

/// Of an IntegerPair.
using ModularEliminant = ModularEliminantOf<EliminantForms<ScalarArithmetic>>;
/// Of a WeightedPair, or a StrippedPair.
template <class Kind>
using WeightedModularEliminant = ModularEliminantOf<FormsOf<ScalarArithmetic, Kind>>;

/// True if E is defined and not zero: l_r l_s Res(R,R') Res(R,S1) is not the zero polynomial. A value that is
/// defined and not zero at one u modulo one prime proves it; false may be a coincidence at both primes.
template <class Eliminant, class Pair>
bool is_generic(const Pair& pair) {
  std::uint64_t p = prime_field_limit;
  for (int attempt = 0; attempt < 2; ++attempt) {
    p = prime_below(p);
    const PrimeField field(p);
    const Residue u = field.residue(static_cast<std::int64_t>(p / 3));
    const ResidueFraction value = Eliminant(field, pair).value(u);
    if (value.numerator != 0 && value.denominator != 0) return true;
  }
  return false;
}

}  // namespace exsect
