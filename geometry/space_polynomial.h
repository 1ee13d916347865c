// Polynomials in x, y, z over Q, sparse: implicit equations of surfaces.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <map>
#include <vector>

namespace exsect {

/// Exponents of x, y, z.
using Exponents = std::array<int, 3>;

/// An element of Q[x,y,z]. Invariant: no stored coefficient is zero, no exponent negative.
class SpacePolynomial {
 public:
  /// Ordered by exponents, lexicographically.
  using Terms = std::map<Exponents, Rational>;

  SpacePolynomial() = default;
  /// Zero coefficients allowed; throws std::invalid_argument for a negative exponent.
  explicit SpacePolynomial(const Terms& terms);
  static SpacePolynomial constant(const Rational& c) { return SpacePolynomial(Terms{{{0, 0, 0}, c}}); }
  /// x, y or z for axis 0, 1, 2.
  static SpacePolynomial variable(std::size_t axis);

  const Terms& terms() const { return terms_; }
  bool is_zero() const { return terms_.empty(); }
  Rational coefficient(const Exponents& e) const;
  /// Total degree, -1 for zero.
  int degree() const;
  /// Degree in x, y or z, -1 for zero.
  int degree_in(std::size_t axis) const;

  Rational operator()(const Point& p) const;
  SpacePolynomial derivative(std::size_t axis) const;
  /// The multiple with coprime integer coefficients, the greatest term (total degree, then lexicographic)
  /// positive; zero for zero.
  SpacePolynomial primitive() const;

  SpacePolynomial& operator+=(const SpacePolynomial& other);
  SpacePolynomial& operator-=(const SpacePolynomial& other);
  friend SpacePolynomial operator+(SpacePolynomial a, const SpacePolynomial& b) { return a += b; }
  friend SpacePolynomial operator-(SpacePolynomial a, const SpacePolynomial& b) { return a -= b; }
  friend SpacePolynomial operator*(const SpacePolynomial& a, const SpacePolynomial& b);
  friend SpacePolynomial operator*(const Rational& c, SpacePolynomial a);
  friend bool operator==(const SpacePolynomial& a, const SpacePolynomial& b) = default;

 private:
  Terms terms_;
};

/// All exponents of total degree at most `degree`, by total degree, then lexicographic; empty for degree < 0.
std::vector<Exponents> exponents_up_to(int degree);

/// f(x(u,v)) with u in the place of r and v in that of s; bidegree at most (2d,2d) for total degree d.
BivariatePolynomial compose(const SpacePolynomial& f, const BezierPatch& x);

}  // namespace exsect
