#include "eliminant/turning_eliminant.h"

#include <exsect/algebra/fixed_point_interval.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/integer_pair.h>

#include <vector>

#include "eliminant/ball_eliminant.h"
#include "eliminant/coordinate_bits.h"
#include "eliminant/eliminant_height.h"
#include "eliminant/special_eliminant.h"
#include "eliminant/turning_eliminant_modular.h"
#include "eliminant/vector_eliminant.h"

namespace exsect {

namespace {

/// E is of degree 40 in each coordinate of space. Doubles of all exponents give half of this number of bits;
/// beyond it the computation would take more than some seconds.
constexpr std::size_t max_bits = std::size_t{1} << 19;

/// What is left of them when the slack of the height bound, some 400 to 600 bits, and what is lost by
/// cancellation from powers to the Bernstein basis, some 250, are subtracted, decides most signs.
constexpr std::size_t leading_bits = 1024;

/// The bits for which values in balls and values modulo primes take the same time.
constexpr std::size_t long_bits = 4000;

std::size_t estimated_bits(const IntegerPair& pair) { return 40 * coordinate_bits(pair); }

ModularIntegers modular_eliminant(const IntegerPair& pair) {
  const std::size_t bits = eliminant_height_bound(pair);
  if (auto by_vectors = vector_eliminant(pair, bits)) return std::move(*by_vectors);
  return interpolate_modular_polynomial(PolynomialKind::degree(2), bits,
                                        [&pair](const PrimeField& field, Residue first, std::size_t count) {
                                          return ModularEliminant(field, pair).values(first, count);
                                        });
}

}  // namespace

TurningEliminant turning_eliminant(const BezierPatch& x, const BezierPatch& y) {
  return in_nearest_rounding([&]() -> TurningEliminant {
    const IntegerPair pair = integer_pair(x, y);
    if (estimated_bits(pair) > max_bits)
      return {std::nullopt, "the numbers are too long: E would have over 2^19 bits", false};
    if (!is_generic<ModularEliminant>(pair)) return special_eliminant(pair);
    const Polynomial e = polynomial_of(chinese_remainder(modular_eliminant(pair)));
    return {primitive_with_positive_lead(e), {}, false};
  });
}

std::optional<EnclosedPolynomial> enclosed_turning_eliminant(const BezierPatch& x, const BezierPatch& y) {
  return in_nearest_rounding([&]() -> std::optional<EnclosedPolynomial> {
    const IntegerPair pair = integer_pair(x, y);
    if (estimated_bits(pair) > max_bits || !is_generic<ModularEliminant>(pair)) return std::nullopt;
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
