// Seeded random rationals and polynomials for the tests and benches of algebra/.
#pragma once

#include <exsect/algebra/polynomial.h>

#include <cstdint>
#include <random>
#include <vector>

namespace exsect::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }

  /// An integer of at most `bits` bits, either sign.
  Integer big_integer(int bits) {
    Integer n = 0;
    for (int i = 0; i < bits; i += 30) n = (n << 30) + integer(0, (1 << 30) - 1);
    n >>= static_cast<unsigned>((bits + 29) / 30 * 30 - bits);
    return integer(0, 1) == 0 ? n : Integer(-n);
  }

  Rational rational(int size, int max_denominator) {
    return Rational(integer(-size, size), integer(1, max_denominator));
  }

  Polynomial polynomial(int degree, int size, int max_denominator = 1) {
    std::vector<Rational> coefficients;
    for (int i = 0; i <= degree; ++i) coefficients.push_back(rational(size, max_denominator));
    return Polynomial(coefficients);
  }

  Polynomial big_polynomial(int degree, int bits) {
    std::vector<Rational> coefficients;
    for (int i = 0; i <= degree; ++i) coefficients.push_back(big_integer(bits));
    return Polynomial(coefficients);
  }

 private:
  std::mt19937_64 engine_;
};

/// t - root.
inline Polynomial linear_factor(const Rational& root) { return Polynomial::variable() - Polynomial(root); }

inline Polynomial with_roots(const std::vector<Rational>& roots) {
  Polynomial product = 1;
  for (const Rational& root : roots) product *= linear_factor(root);
  return product;
}

}  // namespace exsect::test
