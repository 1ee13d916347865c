// Plane algebraic curves f(r,s) = 0 over Q in the unit square: common points, parts, local shape. Exact.
#pragma once

#include <exsect/algebra/triangular_point.h>

#include <optional>
#include <vector>

namespace exsect {

/// f = content(s) primitive(r,s) with the monic content in s; the primitive part vanishes on no line s =
/// const.
struct ContentAndPart {
  Polynomial content;
  BivariatePolynomial primitive;
};
/// Requires f != 0, else std::domain_error.
ContentAndPart split_content(const BivariatePolynomial& f);

/// Every irreducible factor of f exactly once. Requires f != 0, else std::domain_error.
BivariatePolynomial squarefree(const BivariatePolynomial& f);

/// f_r g_s - f_s g_r
BivariatePolynomial jacobian(const BivariatePolynomial& f, const BivariatePolynomial& g);

/// The common zeros of f and g in [0,1]^2, ascending in s, then in r. Requires gcd(f,g) = 1, else
/// std::domain_error.
std::vector<TriangularPoint> common_points(const BivariatePolynomial& f, const BivariatePolynomial& g);

/// The zeros of f on the four sides of [0,1]^2, as far as they are isolated on their side; a corner may come
/// twice.
std::vector<TriangularPoint> side_points(const BivariatePolynomial& f);

/// A point on every connected component of {f = 0} in [0,1]^2 (and possibly more): none if and only if f has
/// no zero there. Requires f squarefree and not zero.
std::vector<TriangularPoint> component_points(const BivariatePolynomial& f);

/// Whether two points given by triangular sets are the same.
bool same_point(const TriangularPoint& p, const TriangularPoint& q);

/// The common zeros of all polynomials in [0,1]^2: those of `curve` (a constant: none; zero: the whole
/// square), and the finitely many others, each once.
struct CommonZeros {
  BivariatePolynomial curve;
  std::vector<TriangularPoint> points;
};
CommonZeros common_zeros(const std::vector<BivariatePolynomial>& polynomials);

/// Whether all of the polynomials vanish at a common point of [0,1]^2.
bool have_common_zero(const std::vector<BivariatePolynomial>& polynomials);

}  // namespace exsect
