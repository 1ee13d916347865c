// Polynomials in two variables (r,s) over Q, dense in r.
#pragma once

#include <exsect/algebra/polynomial.h>

#include <vector>

namespace exsect {

/// An element of Q[s][r]: `coefficient(i)` is the polynomial in s that multiplies r^i. The bidegree is exact:
/// the leading coefficient in r is not the zero polynomial.
class BivariatePolynomial {
 public:
  BivariatePolynomial() = default;
  /// Coefficients of 1, r, r^2, ...; trailing zeros allowed.
  explicit BivariatePolynomial(std::vector<Polynomial> coefficients_of_r);
  static BivariatePolynomial constant(const Rational& c);
  static BivariatePolynomial r();
  static BivariatePolynomial s();

  bool is_zero() const { return coefficients_.empty(); }
  /// Degree in r, -1 for zero.
  int degree_r() const { return static_cast<int>(coefficients_.size()) - 1; }
  /// Degree in s, -1 for zero.
  int degree_s() const;
  /// Largest i + j with a term r^i s^j, -1 for zero.
  int total_degree() const;
  /// The coefficient of r^i as a polynomial in s; zero beyond the degree.
  Polynomial coefficient(int i) const;
  Rational coefficient(int i, int j) const { return coefficient(i).coefficient(j); }

  Rational operator()(const Rational& r, const Rational& s) const;
  /// The polynomial in r at a rational s.
  Polynomial at_s(const Rational& s) const;
  /// The polynomial in s at a rational r.
  Polynomial at_r(const Rational& r) const;
  BivariatePolynomial derivative_r() const;
  BivariatePolynomial derivative_s() const;
  /// The same polynomial with the names of the variables exchanged.
  BivariatePolynomial exchanged() const;

  BivariatePolynomial& operator+=(const BivariatePolynomial& other);
  BivariatePolynomial& operator-=(const BivariatePolynomial& other);
  BivariatePolynomial& operator*=(const Polynomial& factor_in_s);
  friend BivariatePolynomial operator+(BivariatePolynomial a, const BivariatePolynomial& b) { return a += b; }
  friend BivariatePolynomial operator-(BivariatePolynomial a, const BivariatePolynomial& b) { return a -= b; }
  friend BivariatePolynomial operator*(const BivariatePolynomial& a, const BivariatePolynomial& b);
  friend BivariatePolynomial operator*(BivariatePolynomial a, const Polynomial& factor_in_s) {
    return a *= factor_in_s;
  }
  friend bool operator==(const BivariatePolynomial& a, const BivariatePolynomial& b) = default;

 private:
  void trim();
  std::vector<Polynomial> coefficients_;
};

/// a / b in Q[r,s] where b divides a; throws std::domain_error otherwise.
BivariatePolynomial exact_quotient(const BivariatePolynomial& a, const BivariatePolynomial& b);
/// Greatest common divisor in Q[r,s], contents in s included, primitive with positive leading coefficient;
/// gcd(0,0) = 0.
BivariatePolynomial gcd(const BivariatePolynomial& a, const BivariatePolynomial& b);

}  // namespace exsect
