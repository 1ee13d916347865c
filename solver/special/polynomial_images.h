// Pairs of weighted patches that are images of polynomial ones under one projective map of space, and Moebius
// maps of parameters. Internal to solver/; docs/method-doubles.md, section 14.20.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include <array>
#include <optional>
#include <vector>

namespace exsect {

/// x and y are seen through q = (p - centre) / l(p), l(p) = 1 + slope.(p - centre), which is positive on
/// both, in the parameters u' with u = u' / (k (1 - u') + u'): their solutions are in bijection.
struct PolynomialImages {
  BezierPatch x;
  BezierPatch y;
  std::array<Rational, 4> ratios;  // k > 0, of u, v, r, s
  Point centre;
  Point slope;
};

/// Empty if no linear form makes both patches polynomial of bidegree at most (2,2), or if none with rational
/// coefficients is found.
std::optional<PolynomialImages> polynomial_images(const RationalPatch& x, const RationalPatch& y);

/// Puts a result for the images into the parameters and the space of x and y. Bounds count the rounding; they
/// are infinite where the map is not proved to be defined.
void put_back(const PolynomialImages& images, IntersectResult& result);

/// Lengths between the images grow at most by this factor, up to rounding, when they are put back, near the
/// points.
double growth(const PolynomialImages& images, const std::vector<Point>& points);

}  // namespace exsect
