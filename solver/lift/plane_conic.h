// Lines and conics of space above a plane of coordinates u and v. Internal to solver/;
// docs/method-equations.md, section 17.7.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <array>
#include <optional>
#include <vector>

#include "lift/surface_chart.h"
#include "lift/surface_intersection.h"

namespace exsect {

/// Coefficients of a u^2 + b u v + c v^2 + d u + e v + f.
struct PlaneConic {
  Rational a, b, c, d, e, f;

  explicit PlaneConic(const BivariatePolynomial& g);

  Rational discriminant() const { return b * b - 4 * a * c; }
  bool is_degenerate() const { return 4 * a * c * f + b * e * d - a * e * e - c * d * d - f * b * b == 0; }
  /// Requires a discriminant other than 0.
  std::array<Rational, 2> centre() const;
  SpaceCurveKind kind() const;
};

/// Two lines that are conjugate over Q(sqrt(delta)), or parallel: a multiple of their equation is x^2 - delta
/// z^2, or x^2 and a number, with z = 1. The sign of x z tells points of the one from those of the other.
struct ConjugateLines {
  BivariatePolynomial x;
  BivariatePolynomial z;
  Rational delta;  // 0 if they are parallel
};
/// Of a degenerate conic that is irreducible over Q.
ConjugateLines conjugate_lines(const BivariatePolynomial& conic);

/// On the irreducible curve g = 0.
bool vanishes_on(const BivariatePolynomial& f, const BivariatePolynomial& g);

/// A basis of the rational relations sum c_k columns[k] = 0 on the irreducible curve g = 0, in each of the
/// components of the columns, which have equally many.
std::vector<std::vector<Integer>> relations_on(const std::vector<std::vector<BivariatePolynomial>>& columns,
                                               const BivariatePolynomial& g);

/// y = alpha u + beta v + gamma.
using PlaneAbove = std::array<Rational, 3>;

/// One in which all points with a + b y = 0 above the irreducible curve g = 0 are; empty if there is none.
std::optional<PlaneAbove> plane_through(const SheetFunction& f, const BivariatePolynomial& g);

/// The curves of the plane above a conic of degree 2, and above a line, in space: origin + u along_u + v
/// along_v + y along_y of the chart, in directions of any angles.
SpaceCurve conic_in_plane(const SurfaceChart& chart, const PlaneConic& g, const PlaneAbove& plane);
/// One of the two conics above g in the planes y = +- line / sqrt(square), square > 0: without what depends
/// on the sign.
SpaceCurve mirrored_conic(const SurfaceChart& chart, const PlaneConic& g, const BivariatePolynomial& line,
                          const Rational& square);
SpaceCurve line_in_plane(const SurfaceChart& chart, const BivariatePolynomial& g, const PlaneAbove& plane);

}  // namespace exsect
