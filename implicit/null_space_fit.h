// Approximate implicit equations of a curve as approximate null vectors (docs/method-implicit.md, 10.3).
#pragma once

#include <exsect/geometry/bezier_curve.h>
#include <exsect/geometry/planar_space.h>
#include <exsect/implicit/planar_fit.h>

#include <vector>

namespace exsect {

/// The basis alpha in which W^m q(p(t)) = (D b)' alpha(t) (10.5) is made small.
enum class CurveBasis {
  bernstein,  // Dokken: |W^m q(p(t))| <= sigma (10.6)
  legendre,   // orthonormal: least integral of the square over [0,1] (the weak form)
  chebyshev,  // orthonormal for the weight (t - t^2)^(-1/2) (10.7)
  lagrange    // values at equidistant points
};

/// "bernstein", "legendre", "chebyshev", "lagrange".
const char* name(CurveBasis basis);

struct NullSpaceFit {
  std::vector<Rational> coefficients;  // of the functions of the space, length 1 up to rounding
  /// |D b| for these coefficients over |b|, about the least singular value of D.
  double singular_value;
  /// Dimension over Q of {b : D b = 0}: the functions of the space that vanish on the curve. If it is not 0,
  /// the coefficients are one of them and the singular value is 0.
  std::size_t nullity;
};

/// The function of a polynomial space that is least on a planar curve, among those with coefficients of
/// length 1: by a singular value decomposition, or in exact arithmetic by inverse iteration over Q, correct
/// to more digits than doubles have. Whether a function vanishes on the curve is decided by a rank over Q
/// either way. Throws std::invalid_argument for splines, a point, or a curve of space.
NullSpaceFit fit_null_space(const PlanarSpace& space, const BezierCurve& curve, CurveBasis basis,
                            Arithmetic arithmetic);

}  // namespace exsect
