#include "determinant.h"

#include <algorithm>
#include <stdexcept>

#include "flint_polynomial.h"
// after flint.h
#include <flint/fmpz_poly_mat.h>

namespace exsect {
namespace {

using Matrix = std::vector<std::vector<BivariatePolynomial>>;

struct PolynomialMatrix {
  fmpz_poly_mat_t value;

  explicit PolynomialMatrix(slong size) { fmpz_poly_mat_init(value, size, size); }
  ~PolynomialMatrix() { fmpz_poly_mat_clear(value); }
  PolynomialMatrix(const PolynomialMatrix&) = delete;
  PolynomialMatrix& operator=(const PolynomialMatrix&) = delete;
};

/// A bound for the degree in s of the determinant: every product of it takes one entry of each row.
int degree_bound_s(const Matrix& matrix) {
  int bound = 0;
  for (const std::vector<BivariatePolynomial>& row : matrix) {
    int largest = 0;
    for (const BivariatePolynomial& entry : row) largest = std::max(largest, entry.degree_s());
    bound += largest;
  }
  return bound;
}

Integer common_denominator(const BivariatePolynomial& f, Integer common) {
  for (int i = 0; i <= f.degree_r(); ++i) {
    FlintInteger part;
    fmpz_set(part.value, f.coefficient(i).rep().value->den);
    common = lcm(common, part.to_integer());
  }
  return common;
}

/// denominator f(t^stride, t), where denominator times f has integer coefficients.
void substitute(fmpz_poly_t result, const BivariatePolynomial& f, slong stride, const Rational& denominator) {
  const Polynomial scale(denominator);
  for (int i = 0; i <= f.degree_r(); ++i) {
    const Polynomial c = f.coefficient(i) * scale;
    const NumeratorView integers(c);
    for (slong j = 0; j < integers.get()->length; ++j)
      fmpz_poly_set_coeff_fmpz(result, i * stride + j, integers.get()->coeffs + j);
  }
}

/// The polynomial f of degree below stride in s with f(t^stride, t) = g(t) / denominator.
BivariatePolynomial unpacked(const fmpz_poly_t g, slong stride, const Rational& denominator) {
  std::vector<std::vector<Rational>> table;
  for (slong k = 0; k < g->length; ++k) {
    FlintInteger c;
    fmpz_set(c.value, g->coeffs + k);
    const auto i = static_cast<std::size_t>(k / stride);
    if (table.size() <= i) table.emplace_back();
    table[i].push_back(Rational(c.to_integer()) / denominator);
  }
  std::vector<Polynomial> coefficients;
  for (const std::vector<Rational>& row : table) coefficients.emplace_back(row);
  return BivariatePolynomial(std::move(coefficients));
}

}  // namespace

BivariatePolynomial determinant(const Matrix& matrix) {
  for (const std::vector<BivariatePolynomial>& row : matrix)
    if (row.size() != matrix.size()) throw std::invalid_argument("determinant: the matrix is not square");
  // Kronecker: r = t^stride with stride above the degree in s of the determinant loses nothing.
  const slong stride = degree_bound_s(matrix) + 1;
  PolynomialMatrix packed(static_cast<slong>(matrix.size()));
  Rational denominator = 1;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    Integer common = 1;
    for (const BivariatePolynomial& entry : matrix[i]) common = common_denominator(entry, common);
    for (std::size_t j = 0; j < matrix.size(); ++j)
      substitute(fmpz_poly_mat_entry(packed.value, i, j), matrix[i][j], stride, common);
    denominator *= common;
  }
  FlintPolynomial result;
  fmpz_poly_mat_det(result.value, packed.value);
  return unpacked(result.value, stride, denominator);
}

BivariatePolynomial primitive(const BivariatePolynomial& f) {
  FlintRational content, next;
  for (int i = 0; i <= f.degree_r(); ++i) {
    const Polynomial c = f.coefficient(i);
    fmpq_poly_content(next.value, c.rep().value);
    fmpq_gcd(content.value, content.value, next.value);
  }
  if (fmpq_is_zero(content.value)) return f;
  fmpq_inv(content.value, content.value);
  return f * Polynomial(content.to_rational());
}

}  // namespace exsect
