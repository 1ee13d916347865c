#include "turning_eliminant.h"

#include <exsect/geometry/integer_pair.h>

#include <vector>

#include "eliminant_height.h"
#include "turning_eliminant_modular.h"

namespace exsect {

namespace {

constexpr std::size_t degree_bound = 128;

/// E(u) of a pair for which (4.8) is defined and not zero.
std::vector<Integer> generic_eliminant(const IntegerPair& pair) {
  return interpolate_integer_polynomial(degree_bound, eliminant_height_bound(pair),
                                        [&](const PrimeField& field, Residue first, std::size_t count) {
                                          const ModularEliminant eliminant(field, pair);
                                          std::vector<ResidueFraction> values;
                                          Residue u = first;
                                          for (std::size_t i = 0; i < count;
                                               ++i, u = field.add(u, field.one())) {
                                            values.push_back(eliminant.fast_value(u));
                                            if (values.back().denominator == 0)
                                              values.back() = eliminant.value(u);
                                          }
                                          return values;
                                        });
}

Polynomial primitive_polynomial(const std::vector<Integer>& coefficients) {
  const Polynomial f =
      Polynomial(std::vector<Rational>(coefficients.begin(), coefficients.end())).primitive();
  return sign(f.leading_coefficient()) < 0 ? -f : f;
}

/// True if (4.8) is defined and not zero: g_r g_s Res(R,R') Res(R,S1) is not the zero polynomial.
bool is_generic(const IntegerPair& pair) {
  std::uint64_t p = prime_field_limit;
  for (int attempt = 0; attempt < 2; ++attempt) {
    p = prime_below(p);
    const PrimeField field(p);
    const ResidueFraction value =
        ModularEliminant(field, pair).value(field.residue(static_cast<std::int64_t>(p / 3)));
    if (value.numerator != 0 && value.denominator != 0) return true;
  }
  return false;
}

}  // namespace

TurningEliminant turning_eliminant(const BezierPatch& x, const BezierPatch& y) {
  const IntegerPair pair = integer_pair(x, y);
  if (is_generic(pair)) return {primitive_polynomial(generic_eliminant(pair)), {}};
  return {std::nullopt, "g_r, g_s, Res(R,R') or Res(R,S1) vanishes: the fibres are not 16 simple points"};
}

}  // namespace exsect
