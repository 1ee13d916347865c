#include "dixon_matrix.h"

#include <exsect/algebra/modular.h>
#include <exsect/algebra/simplex_interpolation.h>

#include <utility>
#include <vector>

#include "vector_algebra.h"

namespace exsect {
namespace {

constexpr int matrix_size = 8;

using ModularMatrix = std::array<std::array<Residue, matrix_size>, matrix_size>;

/// By elimination; the matrix is used up.
Residue determinant(const PrimeField& field, ModularMatrix& m) {
  Residue result = field.one();
  for (std::size_t k = 0; k < matrix_size; ++k) {
    std::size_t pivot = k;
    while (pivot < matrix_size && m[pivot][k] == 0) ++pivot;
    if (pivot == matrix_size) return field.zero();
    if (pivot != k) {
      std::swap(m[pivot], m[k]);
      result = field.negate(result);
    }
    result = field.multiply(result, m[k][k]);
    const Residue inverse = field.inverse(m[k][k]);
    for (std::size_t i = k + 1; i < matrix_size; ++i) {
      if (m[i][k] == 0) continue;
      const Residue factor = field.multiply(m[i][k], inverse);
      for (std::size_t j = k + 1; j < matrix_size; ++j)
        m[i][j] = field.subtract(m[i][j], field.multiply(factor, m[k][j]));
    }
  }
  return result;
}

/// The coefficients of the determinant modulo p.
SimplexTable determinant(const PrimeField& field, const DixonMatrix& m) {
  std::array<ModularMatrix, 4> part;
  for (std::size_t e = 0; e < 4; ++e)
    for (std::size_t i = 0; i < matrix_size; ++i)
      for (std::size_t j = 0; j < matrix_size; ++j) part[e][i][j] = field.residue(m[i][j][e]);
  const auto add = [&](ModularMatrix to, const ModularMatrix& other) {
    for (std::size_t i = 0; i < matrix_size; ++i)
      for (std::size_t j = 0; j < matrix_size; ++j) to[i][j] = field.add(to[i][j], other[i][j]);
    return to;
  };
  SimplexTable values(matrix_size);
  ModularMatrix at_x = part[0];
  for (int x = 0; x <= matrix_size; ++x, at_x = add(at_x, part[1])) {
    ModularMatrix at_y = at_x;
    for (int y = 0; x + y <= matrix_size; ++y, at_y = add(at_y, part[2])) {
      ModularMatrix at_z = at_y;
      for (int z = 0; x + y + z <= matrix_size; ++z, at_z = add(at_z, part[3])) {
        ModularMatrix matrix = at_z;
        values(x, y, z) = determinant(field, matrix);
      }
    }
  }
  return interpolate(field, std::move(values));
}

/// A bound for the coefficients: the sum of the moduli of all coefficients is submultiplicative, and at most
/// the product over the rows of that of the row.
Integer height_bound(const DixonMatrix& m) {
  Integer bound = 1;
  for (const auto& row : m) {
    Integer sum = 0;
    for (const AffineEntry& entry : row)
      for (const Integer& c : entry) sum += abs(c);
    bound *= sum;
  }
  return bound;
}

}  // namespace

DixonMatrix dixon_matrix(const IntegerNet& c) {
  // det[f(s,t) f(a,t) f(a,b)] = det[f(s,t)-f(a,t)  f(a,t)-f(a,b)  f(a,b)], and the first two columns divided
  // by s - a and t - b are sums over c_ij t^j s^p a^(i-1-p), p < i, and c_kl a^k t^q b^(l-1-q), q < l. Terms
  // with a^4, a^5, b^2, b^3 cancel.
  DixonMatrix m{};
  const auto add = [&](std::size_t s, std::size_t t, std::size_t a, std::size_t b, std::size_t part,
                       const Integer& value) {
    if (a <= 3 && b <= 1) m[a + 4 * b][s + 2 * t][part] += value;
  };
  for (std::size_t i = 1; i <= 2; ++i)
    for (std::size_t j = 0; j <= 2; ++j)
      for (std::size_t k = 0; k <= 2; ++k)
        for (std::size_t l = 1; l <= 2; ++l) {
          const IntegerVector w = cross_over<Integer>(c[i][j], c[k][l]);
          for (std::size_t p = 0; p < i; ++p)
            for (std::size_t q = 0; q < l; ++q) {
              const std::size_t a = i - 1 - p + k, b = l - 1 - q;
              for (std::size_t axis = 0; axis < 3; ++axis) add(p, j + q, a, b, 1 + axis, -w[axis]);
              for (std::size_t g = 0; g <= 2; ++g)
                for (std::size_t h = 0; h <= 2; ++h)
                  add(p, j + q, a + g, b + h, 0, dot_over<Integer>(w, c[g][h]));
            }
        }
  return m;
}

SpacePolynomial determinant(const DixonMatrix& m) {
  const Integer bound = 2 * height_bound(m);
  ModularIntegers modular;
  Integer product = 1;
  for (std::uint64_t p = prime_field_limit; product <= bound;) {
    p = prime_below(p);
    const PrimeField field(p);
    const SimplexTable coefficients = determinant(field, m);
    modular.residues.emplace_back();
    for (const Residue c : coefficients.elements())
      modular.residues.back().push_back(field.representative(c));
    modular.primes.push_back(p);
    product *= p;
  }
  SpacePolynomial::Terms terms;
  if (!modular.primes.empty()) {
    const std::vector<Integer> coefficients = chinese_remainder(modular);
    std::size_t next = 0;
    for (int x = 0; x <= matrix_size; ++x)
      for (int y = 0; x + y <= matrix_size; ++y)
        for (int z = 0; x + y + z <= matrix_size; ++z) terms[{x, y, z}] = coefficients[next++];
  }
  return SpacePolynomial(terms);
}

}  // namespace exsect
