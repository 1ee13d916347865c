#include "revolution.h"

#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/resultant.h>

#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

namespace exsect {
namespace {

/// Every second coefficient of r, from the given one on.
BivariatePolynomial every_second(const BivariatePolynomial& f, int from) {
  std::vector<Polynomial> coefficients;
  for (int i = from; i <= f.degree_r(); i += 2) coefficients.push_back(f.coefficient(i));
  return BivariatePolynomial(std::move(coefficients));
}

std::array<BivariatePolynomial, 3> coordinates(const BezierPatch& patch) {
  const ControlNet c = patch.power_basis();
  std::array<BivariatePolynomial, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<Polynomial> rows;
    for (const auto& row : c) rows.push_back(Polynomial({row[0][k], row[1][k], row[2][k]}));
    result[k] = BivariatePolynomial(std::move(rows));
  }
  return result;
}

/// The polynomial in z, at the place of the first variable.
BivariatePolynomial horner(const Polynomial& f, const BivariatePolynomial& at) {
  BivariatePolynomial value;
  for (int i = f.degree(); i >= 0; --i) value = value * at + BivariatePolynomial::constant(f.coefficient(i));
  return value;
}

}  // namespace

ParityParts parity_parts(const BivariatePolynomial& f) { return {every_second(f, 0), every_second(f, 1)}; }

BivariatePolynomial revolved_by_product(const BivariatePolynomial& f) {
  const ParityParts parts = parity_parts(f);
  return parts.even * parts.even - BivariatePolynomial::r() * (parts.odd * parts.odd);
}

BivariatePolynomial revolved_by_elimination(const BivariatePolynomial& f) {
  if (f.is_zero()) return {};
  // The resultant has degree deg_r f in R: Newton's interpolation at R = 0, 1, ...
  const int degree = f.degree_r();
  const BivariatePolynomial r_squared = BivariatePolynomial::r() * BivariatePolynomial::r();
  std::vector<Polynomial> difference;
  for (int node = 0; node <= degree; ++node)
    difference.push_back(resultant_r(f, r_squared - BivariatePolynomial::constant(node)));
  for (int order = 1; order <= degree; ++order)
    for (int i = degree; i >= order; --i) {
      Polynomial& d = difference[static_cast<std::size_t>(i)];
      d = (d - difference[static_cast<std::size_t>(i - 1)]) * Polynomial(Rational(1, order));
    }
  BivariatePolynomial result;
  for (int node = degree; node >= 0; --node)
    result = result * (BivariatePolynomial::r() - BivariatePolynomial::constant(node)) +
             BivariatePolynomial(std::vector<Polynomial>{difference[static_cast<std::size_t>(node)]});
  return result;
}

BivariatePolynomial revolved_by_substitution(const BivariatePolynomial& f) {
  ParityParts parts = parity_parts(f);
  if (!parts.odd.is_zero())
    throw std::invalid_argument("revolution by substitution: the polynomial has odd powers of r");
  return std::move(parts.even);
}

SpacePolynomial surface_of_revolution(const BivariatePolynomial& g) {
  SpacePolynomial::Terms terms;
  for (int i = 0; i <= g.degree_r(); ++i) {
    const Polynomial in_z = g.coefficient(i);
    for (int k = 0; k <= in_z.degree(); ++k)
      for (int j = 0; j <= i; ++j) terms[{2 * j, 2 * (i - j), k}] = in_z.coefficient(k) * binomial(i, j);
  }
  return SpacePolynomial(terms);
}

BivariatePolynomial compose_revolution(const BivariatePolynomial& g, const BezierPatch& patch) {
  const auto [x, y, z] = coordinates(patch);
  const BivariatePolynomial squared_radius = x * x + y * y;
  BivariatePolynomial value;
  for (int i = g.degree_r(); i >= 0; --i) value = value * squared_radius + horner(g.coefficient(i), z);
  return value;
}

const char* name(Sheet sheet) {
  return sheet == Sheet::own ? "own" : sheet == Sheet::mirrored ? "mirrored" : "both";
}

}  // namespace exsect
