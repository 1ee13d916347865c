// What exsect revolve shows: summary, JSON and picture.
#pragma once

#include <exsect/solver/revolution_patch.h>
#include <exsect/solver/revolve.h>

#include <optional>
#include <string>
#include <vector>

#include "json_forms.h"

namespace exsect::cli {

/// The exact points on one parameter line u = const of the patch.
struct ShownRevolutionLine {
  Rational u;
  RevolutionPatchLine line;
};

/// The surface against a patch.
struct ShownRevolutionPatch {
  std::string name;
  BezierPatch patch;
  RevolutionPatchCurve curve;
  std::vector<ShownRevolutionLine> lines;
};

struct ShownRevolution {
  RevolutionMethod method;
  BezierCurve profile;
  Revolution revolution;
  std::optional<ShownRevolutionPatch> patch;

  /// The distance is bounded, and every meeting of arcs on the patch is resolved.
  bool is_complete() const;
};

std::string revolution_summary(const ShownRevolution& shown);
Json revolution_json(const ShownRevolution& shown);

/// The rz half plane: the profile, the zero set, the mirrored branches that elimination and product add, and
/// the rings; beside it the curve in the parameter square of the patch.
std::string revolution_svg(const ShownRevolution& shown, const std::string& title);

}  // namespace exsect::cli
