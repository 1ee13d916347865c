// Forms of the homogeneous coordinates of space: on patches, and those that vanish there. Internal to
// solver/.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <vector>

namespace exsect {

/// Of one degree in X_1 ... X_4: the coefficients of the monomials in lexicographic order, X_1^e first and
/// X_4^e last.
struct SpaceForm {
  int degree;
  std::vector<Rational> coefficients;
};

/// X in the parameters of a patch.
using VectorPolynomial = std::array<BivariatePolynomial, 4>;
VectorPolynomial components(const RationalPatch& x);

/// The monomials of a degree >= 1 in the order of SpaceForm.
std::vector<BivariatePolynomial> monomials(const VectorPolynomial& x, int degree);

BivariatePolynomial on_patch(const SpaceForm& form, const VectorPolynomial& x);

/// A basis of the coefficients with which the sum of the functions is 0.
std::vector<std::vector<Integer>> relations(const std::vector<BivariatePolynomial>& functions);

/// The coefficients of f in the products of Bernstein polynomials of the degrees (m,n), 2 more than those of
/// f if they are left out: f is positive on the square, or not negative there, if they all are. With the
/// degrees of f this would often show less: those of the weight of a half circle are 1, 0 and 1.
std::vector<Rational> bernstein_values(const BivariatePolynomial& f, int m, int n);
std::vector<Rational> bernstein_values(const BivariatePolynomial& f);

}  // namespace exsect
