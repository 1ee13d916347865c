// The curve of two polynomials in space, seen along a direction in general position. Internal to solver/;
// docs/method-equations.md, section 17.15.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/geometry/space_polynomial.h>

#include <array>
#include <optional>
#include <vector>

namespace exsect {

/// Coordinates P = u a + v b + y c for columns a, b, c of integers with the determinant 1; u = height . P.
struct SpaceFrame {
  std::array<Point, 3> columns;
  Point height;

  Point point(const Rational& u, const Rational& v, const Rational& y) const {
    return u * columns[0] + v * columns[1] + y * columns[2];
  }
};

/// Different ones for attempts 0, 1, ..., general_frames - 1.
inline constexpr int general_frames = 6;
SpaceFrame general_frame(int attempt);

/// c0 + c1 y + c2 y^2 = 0 on the common points of F and G: the second subresultant.
struct SpaceQuadratic {
  std::array<BivariatePolynomial, 3> c;
  BivariatePolynomial along;  // where this has a double zero, 0 if grad F x grad G has no part along y
};

/// The common points of F and G. Invariant: over every complex u there are finitely many, over bounded u they
/// are bounded, and v and y are O(u) on them. They have shadow(u,v) = 0, u in the place of r and v in that of
/// s, and y = -offset / slope where slope != 0 (17.15).
struct SpaceProjection {
  SpaceFrame frame;
  BivariatePolynomial shadow;  // the resultant with respect to y; its degree in v is its total degree
  BivariatePolynomial slope;
  BivariatePolynomial offset;
  std::optional<SpaceQuadratic> quadratic = {};  // if it was asked for
};

/// Empty if the frame is not in general position to the points of F = G = 0 at infinity. The shadow is zero
/// if F and G have a common factor. Requires F and G not constant.
std::optional<SpaceProjection> space_projection(const SpacePolynomial& f, const SpacePolynomial& g,
                                                const SpaceFrame& frame);

/// Of a projection of F and G. Requires degrees of at least 2.
SpaceQuadratic space_quadratic(const SpacePolynomial& f, const SpacePolynomial& g, const SpaceFrame& frame);

/// J = F_v G_y - F_y G_v as a polynomial of space: the rate of u along grad F x grad G.
SpacePolynomial turning_form(const SpacePolynomial& f, const SpacePolynomial& g, const Point& height);

/// E(u), the product of J over the common points (17.16), up to a constant factor; zero if the shadow has a
/// multiple factor. Requires a shadow other than zero.
Polynomial turning_norm(const SpaceProjection& projection);

/// The product of P over the common points over u whose shadow is on an irreducible factor of it, up to a
/// constant factor (17.19). Empty if the slope vanishes on the factor. Requires P != 0.
std::optional<Polynomial> norm_over(const SpaceProjection& projection, const BivariatePolynomial& factor,
                                    const SpacePolynomial& p);

/// A basis of the polynomials of at most this degree that vanish on all common points whose shadow is on an
/// irreducible factor of it (17.19a). Requires that the slope does not vanish on the factor.
std::vector<SpacePolynomial> forms_through(const SpaceProjection& projection,
                                           const BivariatePolynomial& factor, int degree);

/// A polynomial with the sign of P on the common points where the slope is not 0, by (17.15).
BivariatePolynomial sign_below(const SpaceProjection& projection, const SpacePolynomial& p);

/// Generators of lower degree with the same common points: as long as both have one degree and the same
/// leading form but for a factor, a multiple of the first is subtracted from the second, which may become 0.
void lower_degrees(SpacePolynomial& f, SpacePolynomial& g);

}  // namespace exsect
