#include <exsect/algebra/modular.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "flint.h"
#include "interruption.h"

namespace exsect {

PrimeField::PrimeField(std::uint64_t p) : p_(p) {
  if (p <= 2 || p >= prime_field_limit || n_is_prime(p) == 0)
    throw std::invalid_argument("PrimeField: " + std::to_string(p) + " is not an odd prime below 2^59");
  std::uint64_t inverse = p;  // 1/p mod 8, and each Newton step doubles the number of correct bits
  for (int bits = 3; bits < 64; bits *= 2) inverse *= 2 - p * inverse;
  negative_inverse_ = 0 - inverse;
  one_ = static_cast<std::uint64_t>((static_cast<WideWord>(1) << 64) % p);
  square_of_radix_ = static_cast<std::uint64_t>(static_cast<WideWord>(one_) * one_ % p);
}

Residue PrimeField::residue(std::int64_t a) const {
  const std::uint64_t magnitude =
      (a < 0 ? 0 - static_cast<std::uint64_t>(a) : static_cast<std::uint64_t>(a)) % p_;
  const Residue r = multiply(magnitude, square_of_radix_);
  return a < 0 ? negate(r) : r;
}

Residue PrimeField::residue(const Integer& a) const {
  return multiply(mpz_fdiv_ui(a.backend().data(), p_), square_of_radix_);
}

Residue PrimeField::power(Residue a, std::uint64_t exponent) const {
  Residue result = one_;
  for (; exponent != 0; exponent >>= 1) {
    if ((exponent & 1) != 0) result = multiply(result, a);
    a = multiply(a, a);
  }
  return result;
}

Residue PrimeField::inverse(Residue a) const {
  if (a == 0) throw std::domain_error("PrimeField::inverse: zero has no inverse");
  return power(a, p_ - 2);
}

std::uint64_t prime_below(std::uint64_t n) {
  if (n <= 3) throw std::domain_error("prime_below: there is no odd prime below " + std::to_string(n));
  for (std::uint64_t candidate = (n - 2) | 1;; candidate -= 2)
    if (n_is_prime(candidate) != 0) return candidate;
}

void invert_all(const PrimeField& field, std::span<Residue> elements) {
  std::vector<Residue> products;  // products[i] = elements[0] ... elements[i-1]
  products.reserve(elements.size());
  Residue product = field.one();
  for (const Residue a : elements) {
    products.push_back(product);
    product = field.multiply(product, a);
  }
  Residue inverse = field.inverse(product);
  for (std::size_t i = elements.size(); i-- > 0;) {
    const Residue a = elements[i];
    elements[i] = field.multiply(inverse, products[i]);
    inverse = field.multiply(inverse, a);
  }
}

Residue evaluate(const PrimeField& field, std::span<const Residue> coefficients, Residue t) {
  Residue value = 0;
  for (std::size_t i = coefficients.size(); i-- > 0;)
    value = field.add(field.multiply(value, t), coefficients[i]);
  return value;
}

namespace {

std::size_t degree_or_zero(const std::vector<Residue>& f) {
  std::size_t n = f.size();
  while (n > 1 && f[n - 1] == 0) --n;
  return n - 1;
}

/// l^(deg f - deg g + 1) f mod g in place, where g has the true degree deg_g and the leading coefficient l.
void pseudo_reduce(const PrimeField& field, std::vector<Residue>& f, const std::vector<Residue>& g,
                   std::size_t deg_g) {
  const Residue l = g[deg_g];
  for (std::size_t i = f.size(); i-- > deg_g;) {
    const Residue q = field.negate(f[i]);
    for (std::size_t j = 0; j < i - deg_g; ++j) f[j] = field.multiply(l, f[j]);
    for (std::size_t j = 0; j < deg_g; ++j)
      f[i - deg_g + j] =
          field.reduce(static_cast<WideWord>(l) * f[i - deg_g + j] + static_cast<WideWord>(q) * g[j]);
  }
}

}  // namespace

Residue resultant(const PrimeField& field, std::vector<Residue> f, std::vector<Residue> g) {
  if (f.empty() || g.empty()) throw std::invalid_argument("resultant: a polynomial without formal degree");
  Residue result = field.one();
  Residue denominator = field.one();  // not zero
  // res_{m,n}(f,g) for the formal degrees m = f.size()-1, n = g.size()-1; the loop keeps
  // result/denominator * res(f,g) invariant.
  while (true) {
    const std::size_t m = f.size() - 1;
    const std::size_t n = g.size() - 1;
    const std::size_t k = degree_or_zero(g);
    if (n == 0 || m == 0) {
      const Residue last = n == 0 ? field.power(g[0], m) : field.power(f[0], n);
      return field.multiply(field.multiply(result, last), field.inverse(denominator));
    }
    if (g[k] == 0) return 0;
    if (k < n) {  // res_{m,n}(f,g) = f_m^(n-k) res_{m,k}(f,g)
      result = field.multiply(result, field.power(f[m], n - k));
      g.resize(k + 1);
      continue;
    }
    if (m >= n) {  // res_{m,n}(f,g) = (-1)^(n(m-n+1)) g_n^((m-n+1)(1-n)) res_{n-1,n}(g_n^(m-n+1) f mod g, g)
      pseudo_reduce(field, f, g, n);
      denominator = field.multiply(denominator, field.power(g[n], (m - n + 1) * (n - 1)));
      if (n * (m - n + 1) % 2 == 1) result = field.negate(result);
      f.resize(n);
    }
    if ((f.size() - 1) * n % 2 == 1) result = field.negate(result);
    f.swap(g);
  }
}

std::vector<Residue> interpolate(const PrimeField& field, Residue first, std::vector<Residue> values) {
  const std::size_t n = values.size();
  if (n > field.prime()) throw std::invalid_argument("interpolate: more nodes than the field has elements");
  if (n == 0) return values;
  // Newton's form sum_k D_k / k! prod_{i<k} (t - t_i), D_k the k-th difference.
  for (std::size_t k = 1; k < n; ++k)
    for (std::size_t i = n - 1; i >= k; --i) values[i] = field.subtract(values[i], values[i - 1]);
  Residue k_factorial = field.one();
  Residue k_residue = field.one();
  for (std::size_t k = 2; k < n; ++k) {
    k_residue = field.add(k_residue, field.one());
    k_factorial = field.multiply(k_factorial, k_residue);
  }
  Residue inverse_factorial = field.inverse(k_factorial);
  for (std::size_t k = n; k-- > 2;) {
    values[k] = field.multiply(values[k], inverse_factorial);
    inverse_factorial = field.multiply(inverse_factorial, k_residue);
    k_residue = field.subtract(k_residue, field.one());
  }
  // Horner: the polynomial held in values[k+1..] times (t - t_k), plus values[k].
  Residue node = field.negate(field.add(first, field.residue(static_cast<std::int64_t>(n) - 1)));  // -t_(n-1)
  for (std::size_t k = n - 1; k-- > 0;) {
    node = field.add(node, field.one());
    for (std::size_t j = k; j + 1 < n; ++j)
      values[j] = field.add(values[j], field.multiply(node, values[j + 1]));
  }
  return values;
}

namespace {

void check(const ModularIntegers& integers) {
  const auto& [primes, residues] = integers;
  if (primes.empty() || residues.size() != primes.size())
    throw std::invalid_argument(
        "chinese_remainder: needs one row of residues for each of at least one prime");
  auto sorted = primes;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    throw std::invalid_argument("chinese_remainder: equal primes");
  for (const auto& row : residues)
    if (row.size() != residues.front().size())
      throw std::invalid_argument("chinese_remainder: rows of different lengths");
}

}  // namespace

std::vector<Integer> chinese_remainder(const ModularIntegers& integers) {
  check(integers);
  const auto& [primes, residues] = integers;
  fmpz_comb_t comb;
  fmpz_comb_temp_t workspace;
  fmpz_comb_init(comb, primes.data(), static_cast<slong>(primes.size()));
  fmpz_comb_temp_init(workspace, comb);
  FlintInteger value;
  std::vector<mp_limb_t> column(primes.size());
  std::vector<Integer> result(residues.front().size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t k = 0; k < primes.size(); ++k) column[k] = residues[k][i];
    fmpz_multi_CRT_ui(value.value, column.data(), comb, workspace, 1);
    fmpz_get_mpz(result[i].backend().data(), value.value);
  }
  fmpz_comb_temp_clear(workspace);
  fmpz_comb_clear(comb);
  return result;
}

namespace {

/// Points beyond degree + 1 for the first prime.
constexpr std::size_t spare_points = 8;
/// The nodes are consecutive and start here, far from zero: at small integers structured input often makes an
/// expression undefined for every prime.
constexpr std::int64_t first_node = 0x2f61c3e8d9a75b4;

/// Interpolated coefficients, or nothing if a value is undefined.
std::vector<Residue> modular_interpolant(const PrimeField& field, std::size_t points,
                                         const ModularValues& values) {
  const Residue first = field.residue(first_node);
  const std::vector<ResidueFraction> fractions = values(field, first, points);
  std::vector<Residue> coefficients;
  std::vector<Residue> inverses;
  for (const auto& [numerator, denominator] : fractions) {
    if (denominator == 0) return {};
    coefficients.push_back(numerator);
    inverses.push_back(denominator);
  }
  invert_all(field, inverses);
  for (std::size_t i = 0; i < points; ++i) coefficients[i] = field.multiply(coefficients[i], inverses[i]);
  return interpolate(field, first, std::move(coefficients));
}

}  // namespace

namespace {

/// The sum of M/p over the primes p, M their product.
Integer sum_of_cofactors(const std::vector<std::uint64_t>& primes) {
  Integer product = 1;
  Integer sum = 0;
  for (const std::uint64_t p : primes) {
    sum = sum * p + product;
    product *= p;
  }
  return sum;
}

}  // namespace

LeadingParts leading_parts(const ModularIntegers& integers, std::size_t bits) {
  check(integers);
  const auto& [primes, residues] = integers;
  const std::size_t limbs = (bits + FLINT_BITS - 1) / FLINT_BITS;
  const std::size_t count = residues.front().size();
  // c/M is sum_k y_k/p_k modulo 1 with y_k = c (M/p_k)^-1 mod p_k. Modulo 1 is modulo 2^(64 limbs) here;
  // rounding down 1/p_k makes each term smaller by less than y_k < p_k units.
  std::vector<mp_limb_t> sums(count * limbs, 0);
  std::vector<mp_limb_t> reciprocal(limbs + 1);
  Integer error = 0;
  const Integer cofactors =
      sum_of_cofactors(primes);  // M/p_k modulo p_k: the other terms are multiples of p_k
  for (std::size_t k = 0; k < primes.size(); ++k) {
    const mp_limb_t p = primes[k];
    const mp_limb_t inverse = n_invmod(mpz_fdiv_ui(cofactors.backend().data(), p), p);
    const mp_limb_t precomputed = n_mulmod_precomp_shoup(inverse, p);
    std::fill(reciprocal.begin(), reciprocal.end(), 0);
    reciprocal[limbs] = 1;
    mpn_divrem_1(reciprocal.data(), 0, reciprocal.data(), static_cast<mp_size_t>(limbs + 1), p);
    for (std::size_t i = 0; i < count; ++i) {
      const mp_limb_t y = n_mulmod_shoup(inverse, residues[k][i], precomputed, p);
      mpn_addmul_1(sums.data() + i * limbs, reciprocal.data(), static_cast<mp_size_t>(limbs), y);
    }
    error += p;
  }
  LeadingParts result{std::vector<Integer>(count), error};
  FlintInteger sum;
  for (std::size_t i = 0; i < count; ++i) {
    fmpz_set_signed_ui_array(sum.value, sums.data() + i * limbs, static_cast<slong>(limbs));
    fmpz_get_mpz(result.leading[i].backend().data(), sum.value);
  }
  return result;
}

ModularIntegers interpolate_modular_polynomial(std::size_t degree, std::size_t bits,
                                               const ModularValues& values) {
  std::vector<std::uint64_t> primes;
  std::vector<std::vector<std::uint64_t>> residues;
  Integer product = 1;
  for (std::uint64_t p = prime_field_limit; msb(product) < bits + 2;) {
    interruption_point();
    p = prime_below(p);
    const PrimeField field(p);
    auto coefficients = modular_interpolant(field, degree + 1 + (primes.empty() ? spare_points : 0), values);
    if (coefficients.empty()) continue;
    for (std::size_t i = degree + 1; i < coefficients.size(); ++i)
      if (coefficients[i] != 0)
        throw std::logic_error("interpolate_integer_polynomial: the values exceed the stated degree");
    coefficients.resize(degree + 1);
    for (auto& c : coefficients) c = field.representative(c);
    primes.push_back(p);
    residues.push_back(std::move(coefficients));
    product *= p;
  }
  return {std::move(primes), std::move(residues)};
}

std::vector<Integer> interpolate_integer_polynomial(std::size_t degree, std::size_t bits,
                                                    const ModularValues& values) {
  return chinese_remainder(interpolate_modular_polynomial(degree, bits, values));
}

}  // namespace exsect
