#include "resultant.h"

#include <algorithm>
#include <stdexcept>

#include "flint_bivariate.h"
#include "flint_polynomial.h"
#include "modular.h"
// after flint.h
#include <flint/fmpz_poly_mat.h>

namespace exsect {
namespace {

/// Integer coefficients of f (in r) times one positive common denominator, constant term first.
struct IntegerCoefficients {
  std::vector<Polynomial> coefficients;
  Rational denominator;

  explicit IntegerCoefficients(const BivariatePolynomial& f) : denominator(1) {
    Integer common = 1;
    for (int i = 0; i <= f.degree_r(); ++i) {
      FlintInteger part;
      fmpz_set(part.value, f.coefficient(i).rep().value->den);
      common = lcm(common, part.to_integer());
    }
    denominator = common;
    for (int i = 0; i <= f.degree_r(); ++i)
      coefficients.push_back(f.coefficient(i) * Polynomial(denominator));
  }

  int degree() const { return static_cast<int>(coefficients.size()) - 1; }
};

Rational power(const Rational& base, int exponent) {
  Rational result = 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

struct FlintPolynomialMatrix {
  fmpz_poly_mat_t value;

  explicit FlintPolynomialMatrix(slong size) { fmpz_poly_mat_init(value, size, size); }
  ~FlintPolynomialMatrix() { fmpz_poly_mat_clear(value); }
  FlintPolynomialMatrix(const FlintPolynomialMatrix&) = delete;
  FlintPolynomialMatrix& operator=(const FlintPolynomialMatrix&) = delete;
};

/// The determinant of the rows r^(n-j-1) f, ..., f, r^(m-j-1) g, ..., g (m = deg f, n = deg g) on the columns
/// r^(m+n-j-1), ..., r^(j+1), r^k: the coefficient of r^k in S_j.
Polynomial subresultant_coefficient(const IntegerCoefficients& f, const IntegerCoefficients& g, int j,
                                    int k) {
  const int m = f.degree();
  const int n = g.degree();
  const int size = m + n - 2 * j;
  FlintPolynomialMatrix matrix(size);
  for (int row = 0; row < size; ++row) {
    const bool of_f = row < n - j;
    const std::vector<Polynomial>& coefficients = of_f ? f.coefficients : g.coefficients;
    const int shift = of_f ? n - j - 1 - row : size - 1 - row;
    for (int column = 0; column < size; ++column) {
      const int exponent = column == size - 1 ? k : m + n - j - 1 - column;
      const int index = exponent - shift;
      if (index < 0 || index >= static_cast<int>(coefficients.size())) continue;
      fmpz_poly_set(fmpz_poly_mat_entry(matrix.value, row, column),
                    NumeratorView(coefficients[static_cast<std::size_t>(index)]).get());
    }
  }
  FlintPolynomial determinant;
  fmpz_poly_mat_det(determinant.value, matrix.value);
  return to_polynomial(determinant.value);
}

/// S_j of the polynomials themselves over that of the integer ones: n-j rows carry the denominator of f, m-j
/// that of g.
Rational subresultant_scale(const IntegerCoefficients& f, const IntegerCoefficients& g, int j) {
  return 1 / (power(f.denominator, g.degree() - j) * power(g.denominator, f.degree() - j));
}

/// The coefficients' coefficients.
std::vector<std::vector<Integer>> integers(const IntegerCoefficients& f) {
  std::vector<std::vector<Integer>> result;
  for (const Polynomial& c : f.coefficients) {
    std::vector<Integer>& row = result.emplace_back();
    for (int j = 0; j <= c.degree(); ++j) row.push_back(numerator(c.coefficient(j)));
  }
  return result;
}

/// An integer polynomial in r and s whose modulus is less than 2^bits for all r and s of modulus 1.
struct IntegerForm {
  std::vector<std::vector<Integer>> coefficients;  // of r^i s^j, rows may be empty
  std::size_t degree_s = 0;
  std::size_t bits = 1;

  explicit IntegerForm(const IntegerCoefficients& f) : coefficients(integers(f)) {
    Integer squares = 0;
    for (const auto& row : coefficients) {
      degree_s = std::max(degree_s, row.size());
      Integer sum = 0;
      for (const Integer& c : row) sum += abs(c);
      squares += sum * sum;
    }
    degree_s = degree_s == 0 ? 0 : degree_s - 1;
    if (squares != 0) bits = msb(squares) / 2 + 1;
  }

  std::size_t degree() const { return coefficients.size() - 1; }

  std::vector<std::vector<Residue>> modulo(const PrimeField& field) const {
    std::vector<std::vector<Residue>> result;
    for (const auto& row : coefficients) {
      result.emplace_back();
      for (const Integer& c : row) result.back().push_back(field.residue(c));
    }
    return result;
  }
};

/// At s = t, with leading zeros.
std::vector<Residue> value(const PrimeField& field, const std::vector<std::vector<Residue>>& f, Residue t) {
  std::vector<Residue> result;
  for (const auto& row : f) result.push_back(row.empty() ? field.zero() : evaluate(field, row, t));
  return result;
}

/// The resultant with respect to r from its values modulo primes. Its rows have Euclidean length less than
/// 2^f.bits and 2^g.bits where |s| = 1, which by Hadamard bounds it there, and so each of its coefficients.
Polynomial resultant_modular(const IntegerForm& f, const IntegerForm& g) {
  const std::size_t degree = f.degree() * g.degree_s + g.degree() * f.degree_s;
  const std::size_t bits = f.degree() * g.bits + g.degree() * f.bits;
  const std::vector<Integer> coefficients = interpolate_integer_polynomial(
      degree, bits, [&](const PrimeField& field, Residue first, std::size_t count) {
        const auto a = f.modulo(field);
        const auto b = g.modulo(field);
        std::vector<ResidueFraction> values;
        Residue t = first;
        for (std::size_t i = 0; i < count; ++i, t = field.add(t, field.one()))
          values.push_back({resultant(field, value(field, a, t), value(field, b, t)), field.one()});
        return values;
      });
  return Polynomial(std::vector<Rational>(coefficients.begin(), coefficients.end()));
}

BivariatePolynomial constant_in_s(const Polynomial& f) {
  std::vector<Polynomial> coefficients;
  for (int i = 0; i <= f.degree(); ++i) coefficients.emplace_back(f.coefficient(i));
  return BivariatePolynomial(std::move(coefficients));
}

}  // namespace

Rational resultant(const Polynomial& f, const Polynomial& g) {
  FlintRational result;
  fmpq_poly_resultant(result.value, f.rep().value, g.rep().value);
  return result.to_rational();
}

Polynomial resultant_r(const BivariatePolynomial& f, const BivariatePolynomial& g) {
  // FLINT's remainder sequence is faster for low degrees alone.
  constexpr int lowest_modular_degree = 4;
  if (std::min(f.degree_r(), g.degree_r()) >= lowest_modular_degree) {
    const IntegerCoefficients first(f), second(g);
    return resultant_modular(IntegerForm(first), IntegerForm(second)) *
           Polynomial(subresultant_scale(first, second, 0));
  }
  const BivariateContext ring;
  const FlintBivariate first(ring, f), second(ring, g);
  FlintBivariate result(ring);
  if (fmpq_mpoly_resultant(result.value, first.value, second.value, BivariateContext::r, ring.get()) == 0)
    throw std::runtime_error("resultant_r: the computation failed");
  return result.to_bivariate().coefficient(0);
}

Polynomial resultant_s(const BivariatePolynomial& f, const BivariatePolynomial& g) {
  return resultant_r(f.exchanged(), g.exchanged());
}

Polynomial discriminant_r(const BivariatePolynomial& f) {
  const int n = f.degree_r();
  if (n < 1) throw std::domain_error("discriminant_r: the polynomial does not contain r");
  const Polynomial quotient = exact_quotient(resultant_r(f, f.derivative_r()), f.coefficient(n));
  return n * (n - 1) / 2 % 2 == 0 ? quotient : -quotient;
}

std::vector<Polynomial> subresultants(const Polynomial& f, const Polynomial& g) {
  std::vector<Polynomial> result;
  // Over Q[s] with all coefficients constant.
  for (const BivariatePolynomial& member : subresultants_r(constant_in_s(f), constant_in_s(g)))
    result.push_back(member.at_s(0));
  return result;
}

std::vector<BivariatePolynomial> subresultants_r(const BivariatePolynomial& f, const BivariatePolynomial& g) {
  if (f.degree_r() < 1 || g.degree_r() < 1)
    throw std::domain_error("subresultants: both polynomials must be non-constant");
  const IntegerCoefficients first(f), second(g);
  std::vector<BivariatePolynomial> result;
  for (int j = 0; j < std::min(f.degree_r(), g.degree_r()); ++j) {
    const Polynomial scale(subresultant_scale(first, second, j));
    std::vector<Polynomial> coefficients;
    for (int k = 0; k <= j; ++k)
      coefficients.push_back(subresultant_coefficient(first, second, j, k) * scale);
    result.emplace_back(std::move(coefficients));
  }
  return result;
}

Polynomial subresultant_coefficient_r(const BivariatePolynomial& f, const BivariatePolynomial& g, int j,
                                      int k) {
  if (k < 0 || k > j || j >= std::min(f.degree_r(), g.degree_r()))
    throw std::domain_error("subresultant_coefficient_r: 0 <= k <= j < min(deg f, deg g) is required");
  const IntegerCoefficients first(f), second(g);
  return subresultant_coefficient(first, second, j, k) * Polynomial(subresultant_scale(first, second, j));
}

}  // namespace exsect
