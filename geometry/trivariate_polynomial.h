// Polynomials in (u; r,s) over Q, dense in r and s: what a family of lines pulls back to.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <vector>

namespace exsect {

/// An element of Q[u][r,s]. Invariant: the matrix of coefficients is rectangular, and unless it is empty its
/// last row and its last column are not zero.
class TrivariatePolynomial {
 public:
  TrivariatePolynomial() = default;
  /// coefficients[i][j], a polynomial in u, multiplies r^i s^j; rows of any lengths, zeros allowed.
  explicit TrivariatePolynomial(std::vector<std::vector<Polynomial>> coefficients);

  bool is_zero() const { return coefficients_.empty(); }
  /// Degrees, -1 for zero.
  int degree_u() const;
  int degree_r() const { return static_cast<int>(coefficients_.size()) - 1; }
  int degree_s() const { return is_zero() ? -1 : static_cast<int>(coefficients_[0].size()) - 1; }
  /// The coefficient of r^i s^j as a polynomial in u; zero beyond the degrees.
  Polynomial coefficient(int i, int j) const;

  /// The polynomial in (r,s) at a rational u.
  BivariatePolynomial at_u(const Rational& u) const;
  TrivariatePolynomial derivative_r() const;
  TrivariatePolynomial derivative_s() const;

  friend TrivariatePolynomial operator-(const TrivariatePolynomial& a, const TrivariatePolynomial& b);
  friend TrivariatePolynomial operator*(const TrivariatePolynomial& a, const TrivariatePolynomial& b);
  friend bool operator==(const TrivariatePolynomial& a, const TrivariatePolynomial& b) = default;

 private:
  std::vector<std::vector<Polynomial>> coefficients_;
};

}  // namespace exsect
