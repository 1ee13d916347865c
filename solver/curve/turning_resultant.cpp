#include "curve/turning_resultant.h"

#include <exsect/algebra/determinant.h>
#include <exsect/algebra/modular.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace exsect {
namespace {

/// coefficients[j]: of v^j, a list of coefficients in u, constant term first.
using Coefficients = std::vector<std::vector<Integer>>;

Coefficients coefficients_of_v(const BivariatePolynomial& f) {
  Coefficients result;
  const BivariatePolynomial in_v = f.exchanged();
  for (int j = 0; j <= in_v.degree_r(); ++j) {
    result.emplace_back();
    for (const Rational& c : in_v.coefficient(j).coefficients()) result.back().push_back(numerator(c));
  }
  return result;
}

/// Bits of a number that is at least the length of the vector of coefficients for all |u| = 1.
std::size_t norm_bits(const Coefficients& f) {
  Integer squares = 0;
  for (const std::vector<Integer>& in_u : f) {
    Integer sum = 0;
    for (const Integer& c : in_u) sum += abs(c);
    squares += sum * sum;
  }
  return msb(squares) / 2 + 1;
}

std::vector<Residue> at(const PrimeField& field, const std::vector<std::vector<Residue>>& f, Residue u) {
  std::vector<Residue> result;
  for (const std::vector<Residue>& in_u : f) result.push_back(evaluate(field, in_u, u));
  return result;
}

std::vector<std::vector<Residue>> reduced(const PrimeField& field, const Coefficients& f) {
  std::vector<std::vector<Residue>> result;
  for (const std::vector<Integer>& in_u : f) {
    result.emplace_back();
    for (const Integer& c : in_u) result.back().push_back(field.residue(c));
  }
  return result;
}

}  // namespace

Polynomial turning_resultant(const BivariatePolynomial& f) {
  if (f.is_zero()) throw std::domain_error("turning_resultant: the zero polynomial");
  const auto n = static_cast<std::size_t>(f.degree_s());
  if (n == 0) return 1;
  const BivariatePolynomial integral = primitive(f);
  const Coefficients first = coefficients_of_v(integral), second = coefficients_of_v(integral.derivative_s());
  const std::size_t degree = (2 * n - 1) * static_cast<std::size_t>(f.degree_r());
  // A coefficient is at most the greatest modulus on |u| = 1 (Cauchy), where Hadamard's inequality bounds the
  // Sylvester matrix of n - 1 rows of f and n rows of f_v.
  const std::size_t bits = (n - 1) * norm_bits(first) + n * norm_bits(second);
  const ModularValues values = [&](const PrimeField& field, Residue from, std::size_t count) {
    const auto f_residues = reduced(field, first), derivative_residues = reduced(field, second);
    std::vector<ResidueFraction> result;
    for (Residue u = from; result.size() < count; u = field.add(u, field.one()))
      result.push_back(
          {resultant(field, at(field, f_residues, u), at(field, derivative_residues, u)), field.one()});
    return result;
  };
  std::vector<Rational> coefficients;
  for (const Integer& c : interpolate_integer_polynomial(degree, bits, values)) coefficients.emplace_back(c);
  return Polynomial(coefficients);
}

}  // namespace exsect
