// Polynomials in named variables as lists of terms and as text that computer algebra systems read back.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/geometry/space_polynomial.h>

#include <string>
#include <vector>

namespace exsect {

/// coefficient * product of variables[k]^exponents[k]; coefficient != 0.
struct PolynomialTerm {
  Rational coefficient;
  std::vector<int> exponents;
};

/// Invariant: different exponents, one for each variable, highest total degree first, then lexicographic with
/// the first variable highest.
struct PolynomialTerms {
  std::vector<std::string> variables;
  std::vector<PolynomialTerm> terms;

  /// Largest sum of exponents, -1 for zero.
  int total_degree() const;
  /// Largest exponent of each variable, -1 for zero.
  std::vector<int> degrees() const;
};

/// first = r, second = s.
PolynomialTerms terms_of(const BivariatePolynomial& f, const std::string& first, const std::string& second);
/// Variables x, y, z.
PolynomialTerms terms_of(const SpacePolynomial& f);

/// "4*x^2+8*y^2-1", "-3/7*x*y", "0": read back by Singular, Sage and PARI/GP.
std::string to_text(const PolynomialTerms& polynomial);

}  // namespace exsect
