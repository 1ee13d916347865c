// Polynomials that approximate the length of a gradient (docs/method-implicit.md, 10.5).
#pragma once

#include <exsect/geometry/planar_function.h>

namespace exsect {

/// The polynomial h of total degree `degree` with least integral over the box of (|grad f| - h)^2 / (f^2 +
/// epsilon), (10.13), (12.11) and (12.12) of the chapter: a large epsilon weighs the whole box, a small one
/// the curve f = 0. Computed by Gauss' quadrature in floating point and rounded to nine significant decimals
/// of the largest coefficient; nothing rests on how well it fits. Throws std::invalid_argument unless 0 <=
/// degree <= 8, epsilon > 0, f is not constant and the box has positive sides.
BivariatePolynomial fitted_gradient_norm(const BivariatePolynomial& f, const PlanarBox& box, int degree,
                                         const Rational& epsilon);

}  // namespace exsect
