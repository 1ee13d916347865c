#include "polynomial_terms.h"

#include <algorithm>
#include <numeric>

#include "number.h"

namespace exsect {
namespace {

int total_degree_of(const PolynomialTerm& term) {
  return std::accumulate(term.exponents.begin(), term.exponents.end(), 0);
}

void add_term(PolynomialTerms& list, const Rational& coefficient, std::vector<int> exponents) {
  if (coefficient != 0) list.terms.push_back({coefficient, std::move(exponents)});
}

void sort(PolynomialTerms& list) {
  std::sort(list.terms.begin(), list.terms.end(), [](const PolynomialTerm& a, const PolynomialTerm& b) {
    return total_degree_of(a) != total_degree_of(b) ? total_degree_of(a) > total_degree_of(b)
                                                    : a.exponents > b.exponents;
  });
}

/// "x^2*y", "" for the constant term.
std::string monomial(const PolynomialTerm& term, const std::vector<std::string>& variables) {
  std::string text;
  for (std::size_t k = 0; k < variables.size(); ++k) {
    if (term.exponents[k] == 0) continue;
    if (!text.empty()) text += "*";
    text += variables[k];
    if (term.exponents[k] > 1) text += "^" + std::to_string(term.exponents[k]);
  }
  return text;
}

}  // namespace

int PolynomialTerms::total_degree() const {
  int degree = -1;
  for (const PolynomialTerm& term : terms) degree = std::max(degree, total_degree_of(term));
  return degree;
}

std::vector<int> PolynomialTerms::degrees() const {
  std::vector<int> degrees(variables.size(), -1);
  for (const PolynomialTerm& term : terms)
    for (std::size_t k = 0; k < degrees.size(); ++k) degrees[k] = std::max(degrees[k], term.exponents[k]);
  return degrees;
}

PolynomialTerms terms_of(const BivariatePolynomial& f, const std::string& first, const std::string& second) {
  PolynomialTerms list = {{first, second}, {}};
  for (int i = 0; i <= f.degree_r(); ++i) {
    const Polynomial row = f.coefficient(i);
    for (int j = 0; j <= row.degree(); ++j) add_term(list, row.coefficient(j), {i, j});
  }
  sort(list);
  return list;
}

PolynomialTerms terms_of(const SpacePolynomial& f) {
  PolynomialTerms list = {{"x", "y", "z"}, {}};
  for (const auto& [e, c] : f.terms()) add_term(list, c, {e[0], e[1], e[2]});
  sort(list);
  return list;
}

std::string to_text(const PolynomialTerms& polynomial) {
  std::string text;
  for (const PolynomialTerm& term : polynomial.terms) {
    const std::string power = monomial(term, polynomial.variables);
    const Rational size = abs(term.coefficient);
    text += term.coefficient < 0 ? "-" : text.empty() ? "" : "+";
    if (power.empty())
      text += to_string(size);
    else
      text += (size == 1 ? "" : to_string(size) + "*") + power;
  }
  return text.empty() ? "0" : text;
}

}  // namespace exsect
