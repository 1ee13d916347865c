// Solutions whose parameters are numbers of one field.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/polynomial.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/parameter.h>

#include <array>
#include <optional>

namespace exsect {

/// The parameter i is at[i](a), where a is the one root of the modulus in the interval.
struct AlgebraicPlace {
  Polynomial modulus;  // with leading coefficient 1, irreducible as a rule
  RationalInterval between;
  std::array<Polynomial, 4> at;  // of lower degree
};

/// A solution of x(u,v) = y(r,s) in the box of which each parameter is the only turning value in its
/// interval, or the simplest rational number there. It is one: F(at) = 0 modulo the modulus. Empty if none is
/// found.
std::optional<AlgebraicPlace> algebraic_place(const BezierPatch& x, const BezierPatch& y,
                                              const ParameterBox& box);

/// Of a curve f(u,v) = 0: a singular point of the curve without its multiplicities, with r and s as the box
/// has them, rational numbers. Empty if none is found, for f = 0 or where r or s is an interval.
std::optional<AlgebraicPlace> algebraic_place(const BivariatePolynomial& f, const ParameterBox& box);

}  // namespace exsect
