#include "turning_eliminant.h"

#include <exsect/geometry/integer_pair.h>

#include <vector>

#include "eliminant_height.h"
#include "special_eliminant.h"
#include "turning_eliminant_modular.h"

namespace exsect {

namespace {

/// Of E(u): docs/method.md, Theorem 4.3.
constexpr std::size_t degree_bound = 128;

/// Values of E modulo p at u, u + 1, ...
std::vector<ResidueFraction> eliminant_values(const PrimeField& field, const IntegerPair& pair, Residue u,
                                              std::size_t count) {
  const ModularEliminant eliminant(field, pair);
  std::vector<ResidueFraction> values;
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i, u = field.add(u, field.one())) {
    values.push_back(eliminant.fast_value(u));
    if (values.back().denominator == 0) values.back() = eliminant.value(u);
  }
  return values;
}

/// True if (4.8) is defined and not zero: g_r g_s Res(R,R') Res(R,S1) is not the zero polynomial. A value
/// that is defined and not zero at one u modulo one prime proves it; false may be a coincidence at both
/// primes, and then the other route gives a correct answer too.
bool is_generic(const IntegerPair& pair) {
  std::uint64_t p = prime_field_limit;
  for (int attempt = 0; attempt < 2; ++attempt) {
    p = prime_below(p);
    const PrimeField field(p);
    const Residue u = field.residue(static_cast<std::int64_t>(p / 3));
    const ResidueFraction value = ModularEliminant(field, pair).value(u);
    if (value.numerator != 0 && value.denominator != 0) return true;
  }
  return false;
}

}  // namespace

TurningEliminant turning_eliminant(const BezierPatch& x, const BezierPatch& y) {
  const IntegerPair pair = integer_pair(x, y);
  if (!is_generic(pair)) return special_eliminant(pair);
  const std::vector<Integer> e =
      interpolate_integer_polynomial(degree_bound, eliminant_height_bound(pair),
                                     [&pair](const PrimeField& field, Residue first, std::size_t count) {
                                       return eliminant_values(field, pair, first, count);
                                     });
  return {primitive_with_positive_lead(Polynomial(std::vector<Rational>(e.begin(), e.end()))), {}};
}

}  // namespace exsect
