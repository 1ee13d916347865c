// Random polynomials in u and v, of which the zeros are plane curves.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <random>
#include <vector>

namespace exsect::random_curve {

/// Of at most these degrees, with sevenths up to 99/7 for coefficients.
inline BivariatePolynomial random_curve(std::mt19937& generator, int m, int n) {
  std::uniform_int_distribution<int> digit(-99, 99);
  std::vector<Polynomial> rows;
  for (int i = 0; i <= m; ++i) {
    std::vector<Rational> row;
    for (int j = 0; j <= n; ++j) row.emplace_back(digit(generator), 7);
    rows.emplace_back(row);
  }
  return BivariatePolynomial(rows);
}

}  // namespace exsect::random_curve
