// Polynomials in two variables as rows of coefficients, expanded about other points and along lines. Internal
// to solver/.
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

/// The coefficients of f / unit: of r^i s^j at i (n + 1) + j, where n = max(degree_s, degree in s). Requires
/// unit != 0. Those of a polynomial of at least the degrees given.
template <class Ball>
std::vector<Ball> enclosed_coefficients(const BivariatePolynomial& f, const Rational& unit, int degree_r = 0,
                                        int degree_s = 0) {
  std::vector<Ball> c;
  for (int i = 0; i <= std::max(f.degree_r(), degree_r); ++i)
    for (int j = 0; j <= std::max(f.degree_s(), degree_s); ++j)
      c.push_back(Ball::enclosing(f.coefficient(i, j) / unit));
  return c;
}

/// The coefficients of f(r,s), `row` for each power of r, at r = u.
template <class Number>
std::vector<Number> coefficients_over(const std::vector<Number>& c, std::size_t row, const Number& u) {
  std::vector<Number> result(c.end() - static_cast<std::ptrdiff_t>(row), c.end());
  for (std::size_t i = c.size() - row; i > 0; i -= row)
    for (std::size_t j = 0; j < row; ++j) result[j] = result[j] * u + c[i - row + j];
  return result;
}

/// From the coefficients of f(r,s), `row` for each power of r, to those of f(u + r, v + s).
template <class Number>
void shift_to(std::vector<Number>& c, std::size_t row, const Number& u, const Number& v) {
  const std::size_t m = c.size() / row - 1, n = row - 1;
  for (std::size_t k = 0; k < m; ++k)
    for (std::size_t i = m; i-- > k;)
      for (std::size_t j = 0; j < row; ++j) c[i * row + j] += u * c[(i + 1) * row + j];
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = n; j-- > k;) c[i * row + j] += v * c[i * row + j + 1];
}

/// From the coefficients of f(r,s) to those of f(x, slope x + edge) in x.
template <class Number>
std::vector<Number> along_line(const std::vector<Number>& c, std::size_t row, const Number& slope,
                               const Number& edge) {
  const std::size_t m = c.size() / row - 1, n = row - 1;
  std::vector<Number> result(m + n + 1);
  for (std::size_t j = n + 1; j-- > 0;) {
    if (j < n) {
      for (std::size_t i = m + n - j; i > 0; --i) result[i] = result[i] * edge + result[i - 1] * slope;
      result[0] *= edge;
    }
    for (std::size_t i = 0; i <= m; ++i) result[i] += c[i * row + j];
  }
  return result;
}

}  // namespace exsect
