#include "eliminant/weighted_eliminant.h"

#include <exsect/algebra/enclosed_roots.h>
#include <exsect/algebra/fixed_point_interval.h>
#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>

#include "eliminant/ball_eliminant.h"
#include "eliminant/special_eliminant.h"
#include "eliminant/turning_eliminant_modular.h"
#include "eliminant/vector_eliminant.h"
#include "eliminant/weighted_eliminant_height.h"
#include "eliminant/weighted_pair.h"

namespace exsect {

namespace {

/// As of polynomial patches.
constexpr std::size_t kMostBits = std::size_t{1} << 19;
constexpr std::size_t kLeadingBits = 1024;

/// E is of degree 48 in each coordinate.
bool is_too_long(const WeightedPair& pair) {
  std::size_t bits = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    Integer largest = 1;
    for (const WeightedPair::Net* net : {&pair.x, &pair.y})
      for (const auto& row : *net)
        for (const WeightedPair::Vector& c : row) largest = std::max(largest, Integer(abs(c[k])));
    bits += std::size_t{48} * (msb(largest) + 1);
  }
  return bits > kMostBits;
}

/// Empty where E is not defined.
std::optional<ModularIntegers> modulo_primes(const WeightedPair& pair) {
  if (is_too_long(pair) || !is_generic<WeightedModularEliminant>(pair)) return std::nullopt;
  const std::size_t bits = eliminant_height_bound(pair);
  if (auto by_vectors = vector_eliminant(pair, bits)) return by_vectors;
  return interpolate_modular_polynomial(WeightedKind::degree, bits,
                                        [&](const PrimeField& field, Residue first, std::size_t count) {
                                          return WeightedModularEliminant(field, pair).values(first, count);
                                        });
}

}  // namespace

std::optional<Polynomial> weighted_eliminant(const RationalPatch& x, const RationalPatch& y) {
  return in_nearest_rounding([&]() -> std::optional<Polynomial> {
    const auto residues = modulo_primes(weighted_pair(x, y));
    if (!residues) return std::nullopt;
    return primitive_with_positive_lead(polynomial_of(chinese_remainder(*residues)));
  });
}

std::optional<std::vector<RationalInterval>> weighted_turning_roots(const RationalPatch& x,
                                                                    const RationalPatch& y) {
  return in_nearest_rounding([&]() -> std::optional<std::vector<RationalInterval>> {
    const WeightedPair pair = weighted_pair(x, y);
    if (auto roots = turning_roots_in_balls(pair)) return roots;
    const auto residues = modulo_primes(pair);
    if (!residues) return std::nullopt;
    LeadingParts parts = leading_parts(*residues, kLeadingBits);
    return isolate_enclosed_roots({std::move(parts.leading), std::move(parts.error)});
  });
}

}  // namespace exsect
