// Solutions whose parameters are numbers of one field.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/polynomial.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/parameter.h>

#include <array>
#include <functional>
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

/// Binary digits after the point to which parameters have to be known for their field to be found.
inline constexpr int bits_of_places = 1220;
/// Of parameters that are near these, to `bits_of_places`: a place for which is_solution holds. Empty if none
/// is found in fields of degree 8 at most.
std::optional<AlgebraicPlace> algebraic_place(const std::array<Rational, 4>& near,
                                              const std::function<bool(const AlgebraicPlace&)>& is_solution);

/// Of a curve f(u,v) = 0: a singular point of the curve without its multiplicities, with r and s as the box
/// has them, rational numbers. Empty if none is found, for f = 0 or where r or s is an interval.
std::optional<AlgebraicPlace> algebraic_place(const BivariatePolynomial& f, const ParameterBox& box);

}  // namespace exsect
