// The coefficients of the turning eliminant by vector code.
#pragma once

#include <exsect/algebra/modular.h>
#include <exsect/geometry/integer_pair.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "eliminant/weighted_pair.h"

namespace exsect {

/// True if this build and this processor have AVX2 and FMA.
bool has_vector_eliminant();

/// The n-th largest prime below 2^48, n = 0, 1, ...; all above 2^47.
class LanePrimes {
 public:
  std::uint64_t next();

 private:
  std::size_t used_ = 0;
  std::uint64_t last_ = std::uint64_t{1} << 48;
};

/// The coefficients, constant term first, of E(u) of the pair, given that its degree is at most that of
/// the kind of the pair, and its coefficients are less than 2^bits in modulus: as
/// interpolate_modular_polynomial, a proof included. Nothing if has_vector_eliminant() is false, or if E(u)
/// at some node is undefined modulo four successive primes: then a leading coefficient of a remainder
/// sequence vanishes over the integers as well. Throws ProofFailure if the values do not belong to a
/// polynomial of that degree.
std::optional<ModularIntegers> vector_eliminant(const IntegerPair& pair, std::size_t bits);
std::optional<ModularIntegers> vector_eliminant(const WeightedPair& pair, std::size_t bits);
/// Nothing also if D is of another degree than 1 and 2.
std::optional<ModularIntegers> vector_eliminant(const StrippedPair& pair, std::size_t bits);

}  // namespace exsect
