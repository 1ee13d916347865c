// Implicit surfaces of revolution from a planar profile curve (docs/method-implicit.md, section 12).
#pragma once

#include <exsect/geometry/bezier_curve.h>
#include <exsect/implicit/implicit_bounds.h>
#include <exsect/implicit/planar_fit.h>
#include <exsect/implicit/revolution_audit.h>

#include <optional>

namespace exsect {

enum class RevolutionMethod { elimination, product, substitution };
const char* name(RevolutionMethod method);

struct RevolveOptions {
  RevolutionMethod method = RevolutionMethod::elimination;
  /// Degree of a fit by points and normals: total in (r,z), in (r^2,z) for substitution. Nothing: the exact
  /// equation of the profile; not for substitution.
  std::optional<int> degree;
  /// If given, of the degree in z; `degree` is then that in r (in r^2 for substitution).
  std::optional<int> degree_z;
  /// Substitution only: splines of these degrees on the region divided into equal cells.
  std::optional<std::array<int, 2>> cells;
  int samples = 21;
  FitWeights weights;
  /// 0 < r <= b, z: where rings and branches are looked for. Nothing: twice as far as the control points go.
  std::optional<Rectangle> region;
};

struct Revolution {
  PlanarFunction profile;  // f(r,z); for substitution F(r^2,z)
  bool exact;              // f vanishes on the curve
  Rectangle region;
  /// g(R,z), R = x^2 + y^2 (12.1); for a spline one for each of its cells.
  std::vector<BivariatePolynomial> surfaces;
  /// Not for splines, which have neither mirrored branches nor rings.
  std::optional<SingularRings> rings;
  std::optional<BranchAudit> audit;
  /// Of the profile curve and the zeros of `profile`, and so of the surfaces. Exact: one-sided distance 0.
  DistanceBounds bounds;
};

/// Throws std::invalid_argument, naming the reason, for options out of range (degree, samples, weights,
/// region), a profile that is not planar, is a point or a line on the axis, or leaves the half plane r >= 0;
/// for a fit that the samples do not determine; and for substitution if the profile meets the axis r = 0
/// with a tangent that is not orthogonal to it: F(r^2,z) has a gradient along the axis there.
Revolution revolve(const BezierCurve& profile, const RevolveOptions& options);

}  // namespace exsect
