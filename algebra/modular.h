// Arithmetic modulo word-size primes for large exact results: evaluate modulo many primes, interpolate modulo
// each, combine by the Chinese remainder theorem.
#pragma once

#include <exsect/algebra/rational.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace exsect {

__extension__ typedef unsigned __int128 WideWord;  // `using` takes no __extension__

/// An element a of a PrimeField in Montgomery form, a 2^64 mod p, always in [0,p).
using Residue = std::uint64_t;

/// The integers modulo a prime 2 < p < 2^59. Up to `max_products` products of residues may be summed in a
/// WideWord before one `reduce`: each is at most (p-1)^2 and 32 p^2 < 2^64 p.
class PrimeField {
 public:
  static constexpr int max_products = 32;

  /// Throws std::invalid_argument unless p is an odd prime below 2^59 (proved, not probable).
  explicit PrimeField(std::uint64_t p);

  std::uint64_t prime() const { return p_; }
  Residue zero() const { return 0; }
  Residue one() const { return one_; }
  /// The class of an integer.
  Residue residue(std::int64_t a) const;
  Residue residue(const Integer& a) const;
  /// The representative in [0,p).
  std::uint64_t representative(Residue a) const { return reduce(a); }

  /// t / 2^64 mod p in [0,p); requires t < 2^64 p (Montgomery's reduction).
  Residue reduce(WideWord t) const {
    const std::uint64_t q = static_cast<std::uint64_t>(t) * negative_inverse_;
    const auto h = static_cast<std::uint64_t>((t + static_cast<WideWord>(q) * p_) >> 64);
    return h >= p_ ? h - p_ : h;
  }
  Residue add(Residue a, Residue b) const {
    const std::uint64_t sum = a + b;
    return sum >= p_ ? sum - p_ : sum;
  }
  Residue subtract(Residue a, Residue b) const { return a >= b ? a - b : a + (p_ - b); }
  Residue negate(Residue a) const { return a == 0 ? 0 : p_ - a; }
  Residue multiply(Residue a, Residue b) const { return reduce(static_cast<WideWord>(a) * b); }
  Residue power(Residue a, std::uint64_t exponent) const;
  /// Throws std::domain_error for zero.
  Residue inverse(Residue a) const;

 private:
  std::uint64_t p_;
  std::uint64_t negative_inverse_;  // -1/p mod 2^64
  Residue one_;                     // 2^64 mod p
  Residue square_of_radix_;         // 2^128 mod p
};

/// The largest prime below n (proved); throws std::domain_error for n <= 3.
std::uint64_t prime_below(std::uint64_t n);
/// Where a list of primes for PrimeField starts: successive `prime_below` from here, all above 2^58.
inline constexpr std::uint64_t prime_field_limit = std::uint64_t{1} << 59;

/// Replaces each element by its inverse, with one inversion. Throws std::domain_error if one is zero.
void invert_all(const PrimeField& field, std::span<Residue> elements);

/// Value at t of the polynomial with these coefficients, constant term first.
Residue evaluate(const PrimeField& field, std::span<const Residue> coefficients, Residue t);
/// Resultant of the Sylvester matrix of the formal degrees size-1 (leading zeros count as coefficients);
/// neither may be empty, else std::invalid_argument. Euclid's algorithm: handles every sequence of degrees.
Residue resultant(const PrimeField& field, std::vector<Residue> f, std::vector<Residue> g);
/// The coefficients, constant term first, of the polynomial of degree below values.size() that takes
/// values[i] at first + i. Throws std::invalid_argument if there are more than p values.
std::vector<Residue> interpolate(const PrimeField& field, Residue first, std::vector<Residue> values);

/// Integers modulo several primes: residues[k][i] in [0, primes[k]).
struct ModularIntegers {
  std::vector<std::uint64_t> primes;
  std::vector<std::vector<std::uint64_t>> residues;
};

/// The integers of least absolute value with the given representatives: result[i] = residues[k][i] modulo
/// primes[k] for every k, determined if |result[i]| < (product of the primes)/2. The rows residues[k] have
/// equal lengths. Throws std::invalid_argument for an empty list, wrong shape or equal primes.
std::vector<Integer> chinese_remainder(const ModularIntegers& integers);

/// The c_i of chinese_remainder divided by the product M of the primes, in some unit <= 2^-bits: for one n >=
/// bits, |c_i 2^n / M - leading[i]| <= error, the number of primes times the greatest. The |c_i| must be
/// known to be less than M/4 in modulus, and the error less than 2^bits / 4. Throws as chinese_remainder.
struct LeadingParts {
  std::vector<Integer> leading;
  Integer error;
};
LeadingParts leading_parts(const ModularIntegers& integers, std::size_t bits);

/// A value numerator/denominator; undefined where the denominator is zero.
struct ResidueFraction {
  Residue numerator;
  Residue denominator;
};

/// Values of one integer polynomial modulo a prime at first, first + 1, ..., first + count - 1.
using ModularValues =
    std::function<std::vector<ResidueFraction>(const PrimeField& field, Residue first, std::size_t count)>;

/// The coefficients, constant term first, of the integer polynomial of degree at most `degree` whose
/// coefficients are less than 2^bits in modulus. The bound is the caller's proof: primes are used until their
/// product exceeds 2^(bits+2). A prime at which a value is undefined is left out (so the values must be
/// defined for all but finitely many primes). For the first prime some more values are asked for:
/// std::logic_error if they do not belong to a polynomial of the stated degree.
ModularIntegers interpolate_modular_polynomial(std::size_t degree, std::size_t bits,
                                               const ModularValues& values);
/// The same as integers.
std::vector<Integer> interpolate_integer_polynomial(std::size_t degree, std::size_t bits,
                                                    const ModularValues& values);

}  // namespace exsect
