// The moving planes of low degree that follow a rational curve, and what they say about its points. Internal
// to solver/.
#pragma once

#include <exsect/algebra/polynomial.h>
#include <exsect/algebra/rational.h>

#include <array>
#include <vector>

namespace exsect {

/// The rational curve of the homogeneous vectors C(t), without common factor.
using HomogeneousCurve = std::array<Polynomial, 4>;

/// The greatest common divisor of the four components divided out; requires one that is not zero.
HomogeneousCurve without_common_factor(const HomogeneousCurve& curve);
int degree(const HomogeneousCurve& curve);

/// coefficients[i] is the plane at t^i.
using MovingPlane = std::vector<std::array<Rational, 4>>;

/// A basis of the moving planes M(t) of degree at most `degree` >= 0 with M(t) . C(t) = 0 identically.
std::vector<MovingPlane> moving_planes(const HomogeneousCurve& curve, int degree);

}  // namespace exsect
