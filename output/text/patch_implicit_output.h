// Implicit equations of patches as text and JSON.
#pragma once

#include <exsect/geometry/approximate_implicit_patch.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/space_polynomial.h>

#include <optional>
#include <string>
#include <vector>

#include "output/text/implicit_json.h"

namespace exsect::cli {

/// exact, or approximate of a degree.
struct PatchOptions {
  std::optional<PatchFit> fit;  // exact without it
  int degree = 4;               // of the fit
};

/// An exact or an approximate equation of a patch.
struct PatchImplicit {
  SpacePolynomial equation;
  std::vector<Proved> proved;
  std::optional<double> singular_value;  // of an approximate equation
  std::optional<Point> centre;           // in whose coordinates (P - centre)/unit it was found
  std::optional<Rational> unit;

  bool is_exact() const { return proved.front().name == "exact"; }
};

/// Throws what implicit_equation and approximate_equation throw.
PatchImplicit implicitize_patch(const BezierPatch& patch, const PatchOptions& options);

std::string patch_implicit_summary(const PatchImplicit& implicit, const PatchOptions& options);
Json patch_implicit_json(const PatchImplicit& implicit, const PatchOptions& options);

}  // namespace exsect::cli
