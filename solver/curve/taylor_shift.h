// Polynomials in two variables as rows of balls, expanded about other points. Internal to solver/.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <algorithm>
#include <vector>

namespace exsect {

/// The largest |coefficient|; 0 for f = 0.
inline Rational greatest_coefficient(const BivariatePolynomial& f) {
  Rational most = 0;
  for (int i = 0; i <= f.degree_r(); ++i)
    for (int j = 0; j <= f.degree_s(); ++j) most = std::max<Rational>(most, abs(f.coefficient(i, j)));
  return most;
}

/// The coefficients of f / unit: of r^i s^j at i (n + 1) + j, where n = max(0, degree in s). Requires
/// unit != 0. At least one coefficient.
template <class Ball>
std::vector<Ball> enclosed_coefficients(const BivariatePolynomial& f, const Rational& unit) {
  std::vector<Ball> c;
  for (int i = 0; i <= std::max(f.degree_r(), 0); ++i)
    for (int j = 0; j <= std::max(f.degree_s(), 0); ++j)
      c.push_back(Ball::enclosing(f.coefficient(i, j) / unit));
  return c;
}

/// From the coefficients of f(r,s), `row` for each power of r, to those of f(u + r, v + s).
template <class Ball>
void shift_to(std::vector<Ball>& c, std::size_t row, const Ball& u, const Ball& v) {
  const std::size_t m = c.size() / row - 1, n = row - 1;
  for (std::size_t k = 0; k < m; ++k)
    for (std::size_t i = m; i-- > k;)
      for (std::size_t j = 0; j < row; ++j) c[i * row + j] += u * c[(i + 1) * row + j];
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = n; j-- > k;) c[i * row + j] += v * c[i * row + j + 1];
}

}  // namespace exsect
