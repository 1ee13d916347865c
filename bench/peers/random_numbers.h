// Exact numbers from a generator: the same for the same seed on every machine.
#pragma once

#include <exsect/algebra/rational.h>

#include <random>

namespace peers {

using Generator = std::mt19937_64;

/// Uniform in {lowest, ..., highest}.
inline long integer(Generator& generator, long lowest, long highest) {
  const auto count = static_cast<std::uint64_t>(highest - lowest + 1);
  return lowest + static_cast<long>(generator() % count);
}

/// Uniform in {lowest/16, ..., highest/16}.
inline exsect::Rational sixteenths(Generator& generator, long lowest, long highest) {
  return exsect::Rational(integer(generator, lowest, highest), 16);
}

/// Uniform among the multiples of 2^-52 in [-1,1).
inline exsect::Rational unit_double(Generator& generator) {
  return exsect::from_double(static_cast<double>(generator() >> 11U) * 0x1p-52 - 1);
}

}  // namespace peers
