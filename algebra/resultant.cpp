#include "resultant.h"

#include <algorithm>
#include <stdexcept>

#include "flint_bivariate.h"
#include "flint_polynomial.h"
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

BivariatePolynomial in_r(const Polynomial& f) {
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
  for (const BivariatePolynomial& member : subresultants_r(in_r(f), in_r(g)))
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
