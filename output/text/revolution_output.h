// What exsect revolve shows: summary, JSON and picture.
#pragma once

#include <exsect/implicit/revolution_patch.h>
#include <exsect/implicit/revolve.h>

#include <optional>
#include <string>
#include <vector>

#include "output/text/json_forms.h"

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

}  // namespace exsect::cli
