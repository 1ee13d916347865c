// Eliminants of pairs with weights by the slower ways, against which the others are tested.
#pragma once

#include <exsect/algebra/modular.h>
#include <exsect/algebra/real_algebraic.h>

#include "eliminant/turning_eliminant_modular.h"
#include "eliminant/vector_eliminant.h"
#include "eliminant/weighted_eliminant.h"
#include "eliminant/weighted_eliminant_height.h"
#include "support/catch.h"

namespace exsect::scalar_eliminant {

inline std::size_t bits(const std::vector<Integer>& coefficients) {
  Integer largest = 1;
  for (const Integer& c : coefficients) largest = std::max(largest, Integer(abs(c)));
  return msb(largest) + 1;
}

/// The coefficients of E, which have at most that many bits.
inline std::vector<Integer> coefficients(const WeightedPair& pair, std::size_t count_of_bits) {
  return by_kind(pair, [&]<class Kind>(Kind) {
    return interpolate_integer_polynomial(Kind::degree(pair.x.size() - 1), count_of_bits,
                                          [&](const PrimeField& field, Residue u, std::size_t count) {
                                            const WeightedModularEliminant<Kind> e(field, pair);
                                            std::vector<ResidueFraction> values;
                                            for (std::size_t i = 0; i < count;
                                                 ++i, u = field.add(u, field.one()))
                                              values.push_back(e.value(u));
                                            return values;
                                          });
  });
}

/// The bound of the bits of E is one, by no more than `slack`, and vectors have the same coefficients.
inline void check_vectors_and_bound(const WeightedPair& pair, std::size_t slack) {
  const std::size_t bound = eliminant_height_bound(pair);
  const std::vector<Integer> e = coefficients(pair, bound + 200);
  INFO("bound " << bound << ", actual " << bits(e));
  CHECK(bits(e) <= bound);
  CHECK(bound <= bits(e) + slack);
  const auto by_vectors = vector_eliminant(pair, bound);
  if (!has_vector_eliminant()) return;
  REQUIRE(by_vectors);
  CHECK(chinese_remainder(*by_vectors) == e);
}

/// How many enclosed roots there are along u; checks that they are those of the exact eliminant. Empty where
/// they are not decided.
inline std::optional<std::size_t> checked_roots(const RationalPatch& x, const RationalPatch& y) {
  const auto roots = weighted_turning_roots(x, y, Parameter::u);
  if (!roots) return std::nullopt;
  const auto e = weighted_eliminant(x, y, Parameter::u);
  REQUIRE(e);
  const auto exact = real_roots(*e, 0, 1);
  REQUIRE(roots->size() == exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    CHECK(exact[i].compare((*roots)[i].at.lower) > 0);
    CHECK(exact[i].compare((*roots)[i].at.upper) < 0);
    CHECK((*roots)[i].order == 1);
  }
  return exact.size();
}

}  // namespace exsect::scalar_eliminant
