// Planar curve in, implicit function with its certificates out.
#pragma once

#include <exsect/geometry/implicit_curve.h>
#include <exsect/implicit/implicit_bounds.h>
#include <exsect/implicit/null_space_fit.h>
#include <exsect/implicit/planar_fit.h>

#include <optional>

namespace exsect {

enum class PlanarMethod { exact, least_squares, bernstein, legendre, chebyshev, lagrange };
enum class SpaceKind { monomial, bernstein, b_spline };

/// "exact", "least-squares", "bernstein", ...; "monomial", "bernstein", "b-spline".
const char* name(PlanarMethod method);
const char* name(SpaceKind kind);

struct PlanarOptions {
  PlanarMethod method = PlanarMethod::exact;
  int degree = 3;  // total degree of monomials, degree in x and in y of the others; not used by `exact`
  SpaceKind space = SpaceKind::monomial;
  int cells = 8;                      // of splines, along the longer side of the box
  int samples = 21;                   // of least squares
  std::optional<FitWeights> weights;  // of least squares; w1 = 1, w2 = 0, for splines w2 = 1/1000
  Arithmetic arithmetic = Arithmetic::floating;
  std::optional<int> digits;     // after the point of the coefficients; found from the residual
  std::optional<PlanarBox> box;  // of the space; the box of the control points, a quarter larger
};

struct PlanarImplicit {
  PlanarFunction function;
  PlanarBox box;
  /// The function is the exact irreducible equation: proved to vanish on the curve.
  bool is_exact;
  /// How often the parametrisation runs through the curve, and the degree of the exact equation.
  int power;
  int exact_degree;
  std::size_t dimension;                 // of the space
  std::optional<int> digits;             // to which the coefficients were rounded
  std::optional<double> singular_value;  // of the null space methods
  bool is_unique;                        // of least squares
  DistanceBounds bounds;
  /// Boxes of `box` outside of which the zero set has no singular point there.
  std::vector<PlanarBox> possibly_singular;
};

/// The implicit function of a planar curve by the method, its coefficients rounded to short rationals, with
/// the bounds that are proved for this rounded function. If the rank over Q shows that a null space method's
/// space holds an exact equation, the result is that equation. Throws std::invalid_argument for curves and
/// options out of range, std::domain_error where samples do not determine a spline.
PlanarImplicit implicitize(const BezierCurve& curve, const PlanarOptions& options);

/// The box of the control points, a quarter of its longer side larger on every side, with short ends.
PlanarBox enlarged_box(const BezierCurve& planar);

}  // namespace exsect
