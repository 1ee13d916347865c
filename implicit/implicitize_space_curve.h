// Curve of space in, pair of surfaces with its certificates out.
#pragma once

#include <exsect/implicit/further_branches.h>
#include <exsect/implicit/implicitize_curve.h>
#include <exsect/implicit/space_curve_surfaces.h>

#include <array>
#include <optional>

namespace exsect {

/// Algorithm 2; Algorithm 3; f and G*.
enum class SpaceMethod { cylinders, orthogonal, root_free };

/// "cylinders", "orthogonal", "root-free".
const char* name(SpaceMethod method);

struct SpaceOptions {
  SpaceMethod method = SpaceMethod::cylinders;
  std::optional<int> axis;              // common coordinate of the two projections; chosen without it
  std::optional<PlanarOptions> planar;  // how the projections are implicitized; exactly without it
  int factor_degree = 2;                // of the norms of Algorithm 3
  Rational epsilon = 1000;              // of their weight (12.12)
  std::optional<SpaceBox> box;          // the box of the control points, a quarter larger
};

struct SpaceImplicit {
  int axis;
  bool is_regular;  // the axis coordinate is proved to be strictly monotone
  SpaceBox box;
  std::array<PlanarImplicit, 2> projections;  // f and g with the bounds of the projected curves
  SurfacePair surfaces;
  /// The norms of Algorithm 3, and whether both are proved to be positive in the box: then the surfaces meet
  /// exactly where f = g = 0.
  std::optional<std::array<BivariatePolynomial, 2>> norms;
  bool norms_are_positive;
  GradientAngle angle;
  FurtherBranches further;

  bool is_exact() const { return projections[0].is_exact && projections[1].is_exact; }
};

/// Throws std::invalid_argument for curves and options out of range, and if a given axis has a projection
/// that is a point.
SpaceImplicit implicitize_space(const BezierCurve& curve, const SpaceOptions& options);

}  // namespace exsect
