#include "eliminant/turning_eliminant.h"

#include <exsect/algebra/fixed_point_interval.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/integer_pair.h>

#include <algorithm>
#include <vector>

#include "eliminant/ball_eliminant.h"
#include "eliminant/eliminant_height.h"
#include "eliminant/special_eliminant.h"
#include "eliminant/turning_eliminant_modular.h"
#include "eliminant/vector_eliminant.h"

namespace exsect {

namespace {

/// Of E(u): docs/method.md, Theorem 4.3.
constexpr std::size_t degree_bound = 128;

/// E is of degree 40 in each coordinate of space. Doubles of all exponents give half of this number of bits;
/// beyond it the computation would take more than some seconds.
constexpr std::size_t max_bits = std::size_t{1} << 19;

/// What is left of them when the slack of the height bound, some 400 to 600 bits, and what is lost by
/// cancellation from powers to the Bernstein basis, some 250, are subtracted, decides most signs.
constexpr std::size_t leading_bits = 1024;

/// The bits for which values in balls and values modulo primes take the same time.
constexpr std::size_t long_bits = 4000;

std::size_t estimated_bits(const IntegerPair& pair) {
  std::size_t bits = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    Integer largest = 1;
    for (const IntegerNet* net : {&pair.x, &pair.y})
      for (const auto& row : *net)
        for (const IntegerVector& c : row) largest = std::max(largest, Integer(abs(c[k])));
    bits += 40 * (msb(largest) + 1);
  }
  return bits;
}

/// Values of E modulo p at u, u + 1, ...
std::vector<ResidueFraction> eliminant_values(const PrimeField& field, const IntegerPair& pair, Residue u,
                                              std::size_t count) {
  const ModularEliminant eliminant(field, pair);
  std::vector<ResidueFraction> values = eliminant.fast_values(u, count);
  for (ResidueFraction& value : values) {
    if (value.denominator == 0) value = eliminant.value(u);
    u = field.add(u, field.one());
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

ModularIntegers modular_eliminant(const IntegerPair& pair) {
  const std::size_t bits = eliminant_height_bound(pair);
  if (auto by_vectors = vector_eliminant(pair, bits)) return std::move(*by_vectors);
  return interpolate_modular_polynomial(degree_bound, bits,
                                        [&pair](const PrimeField& field, Residue first, std::size_t count) {
                                          return eliminant_values(field, pair, first, count);
                                        });
}

}  // namespace

TurningEliminant turning_eliminant(const BezierPatch& x, const BezierPatch& y) {
  return in_nearest_rounding([&]() -> TurningEliminant {
    const IntegerPair pair = integer_pair(x, y);
    if (estimated_bits(pair) > max_bits)
      return {std::nullopt, "the numbers are too long: E would have over 2^19 bits", false};
    if (!is_generic(pair)) return special_eliminant(pair);
    const Polynomial e = polynomial_of(chinese_remainder(modular_eliminant(pair)));
    return {primitive_with_positive_lead(e), {}, false};
  });
}

std::optional<EnclosedPolynomial> enclosed_turning_eliminant(const BezierPatch& x, const BezierPatch& y) {
  return in_nearest_rounding([&]() -> std::optional<EnclosedPolynomial> {
    const IntegerPair pair = integer_pair(x, y);
    if (estimated_bits(pair) > max_bits || !is_generic(pair)) return std::nullopt;
    LeadingParts parts = leading_parts(modular_eliminant(pair), leading_bits);
    return EnclosedPolynomial{std::move(parts.leading), std::move(parts.error)};
  });
}

std::optional<std::vector<RationalInterval>> enclosed_turning_roots(const BezierPatch& x,
                                                                    const BezierPatch& y) {
  return in_nearest_rounding([&]() -> std::optional<std::vector<RationalInterval>> {
    const IntegerPair pair = integer_pair(x, y);
    if (estimated_bits(pair) > long_bits) {
      if (auto roots = turning_roots_in_balls(pair)) return roots;
    }
    const auto e = enclosed_turning_eliminant(x, y);
    return e ? isolate_enclosed_roots(*e) : std::nullopt;
  });
}

}  // namespace exsect
