#include "lift/common_factor.h"

#include <exsect/algebra/trivariate_gcd.h>

#include <stdexcept>

namespace exsect {
namespace {

/// x, y and z in the places of r, s and u.
TrivariateCoefficients table_of(const SpacePolynomial& f) {
  TrivariateCoefficients table(static_cast<std::size_t>(f.degree_in(0)) + 1);
  const Polynomial z = Polynomial::variable();
  for (const auto& [e, c] : f.terms()) {
    std::vector<Polynomial>& row = table[static_cast<std::size_t>(e[0])];
    if (row.size() <= static_cast<std::size_t>(e[1])) row.resize(static_cast<std::size_t>(e[1]) + 1);
    Polynomial term = c;
    for (int i = 0; i < e[2]; ++i) term *= z;
    row[static_cast<std::size_t>(e[1])] += term;
  }
  return table;
}

SpacePolynomial polynomial_of(const TrivariateCoefficients& table) {
  SpacePolynomial::Terms terms;
  for (std::size_t i = 0; i < table.size(); ++i)
    for (std::size_t j = 0; j < table[i].size(); ++j)
      for (int k = 0; k <= table[i][j].degree(); ++k)
        terms[{static_cast<int>(i), static_cast<int>(j), k}] = table[i][j].coefficient(k);
  return SpacePolynomial(terms);
}

}  // namespace

SpacePolynomial common_factor(const SpacePolynomial& f, const SpacePolynomial& g) {
  return polynomial_of(gcd(table_of(f), table_of(g))).primitive();
}

SpacePolynomial exact_quotient(const SpacePolynomial& f, const SpacePolynomial& g) {
  SpacePolynomial rest = f, quotient;
  const auto& [leading, factor] = *g.terms().rbegin();
  while (!rest.is_zero()) {
    const auto& [greatest, c] = *rest.terms().rbegin();
    Exponents e;
    for (std::size_t k = 0; k < 3; ++k) e[k] = greatest[k] - leading[k];
    if (e[0] < 0 || e[1] < 0 || e[2] < 0) throw std::domain_error("exact_quotient: there is a remainder");
    const SpacePolynomial term(SpacePolynomial::Terms{{e, Rational(c / factor)}});
    quotient += term;
    rest -= term * g;
  }
  return quotient;
}

SpacePolynomial squarefree_part(const SpacePolynomial& f) {
  SpacePolynomial multiple = f;
  for (std::size_t k = 0; k < 3; ++k) {
    const SpacePolynomial derivative = f.derivative(k);
    if (!derivative.is_zero()) multiple = common_factor(multiple, derivative);
  }
  return f.degree() < 1 ? f : exact_quotient(f, multiple);
}

}  // namespace exsect
