#include "eliminant/stripped_eliminant.h"

#include <exsect/algebra/real_algebraic.h>

#include <algorithm>
#include <vector>

#include "eliminant/special_eliminant.h"
#include "eliminant/turning_eliminant_modular.h"
#include "eliminant/vector_eliminant.h"

namespace exsect {

namespace {

/// y_i of Y = y_0 + y_1 r + ..., coordinate k.
Polynomial coordinate(const WeightedPair::Net& y, std::size_t i, std::size_t k) {
  std::vector<Rational> coefficients;
  for (const WeightedPair::Vector& c : y[i]) coefficients.emplace_back(c[k]);
  return Polynomial(std::move(coefficients));
}

bool has_root_inside(const Polynomial& f) {
  return std::ranges::any_of(real_roots(f, 0, 1), [](const RealAlgebraic& root) {
    return root.compare(0) > 0 && root.compare(1) < 0;
  });
}

}  // namespace

Polynomial point_lines(const WeightedPair::Net& y) {
  Polynomial common;
  for (std::size_t i = 0; i < y.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t l = 0; l < k; ++l)
          common = gcd(common,
                       coordinate(y, i, k) * coordinate(y, j, l) - coordinate(y, i, l) * coordinate(y, j, k));
  return common.is_zero() ? common : primitive_with_positive_lead(common);
}

std::optional<ModularIntegers> stripped_eliminant(const WeightedPair& pair, std::size_t bits) {
  const Polynomial factor = point_lines(pair.y);
  if (factor.degree() < 1 || has_root_inside(factor)) return std::nullopt;
  StrippedPair stripped{pair, {}};
  for (const Rational& c : factor.coefficients()) stripped.factor.emplace_back(numerator(c));
  return by_kind(stripped, [&]<class Kind>(Kind) -> std::optional<ModularIntegers> {
    using Eliminant = WeightedModularEliminant<Kind>;
    if (!is_generic<Eliminant>(stripped)) return std::nullopt;
    if (auto by_vectors = vector_eliminant(stripped, bits)) return by_vectors;
    return interpolate_modular_polynomial(Kind::degree(pair.x.size() - 1), bits,
                                          [&](const PrimeField& field, Residue first, std::size_t count) {
                                            return Eliminant(field, stripped).values(first, count);
                                          });
  });
}

}  // namespace exsect
