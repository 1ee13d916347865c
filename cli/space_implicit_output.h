// Pairs of surfaces through a curve of space as text, JSON and picture.
#pragma once

#include <exsect/solver/implicitize_space_curve.h>

#include <string>
#include <vector>

#include "implicit_json.h"

namespace exsect::cli {

/// What is proved and what is not.
PlanarStatements space_statements(const SpaceImplicit& implicit);
/// The projections are exact or their distances are bounded, and so is the angle.
bool is_complete(const SpaceImplicit& implicit);

std::string space_implicit_summary(const SpaceImplicit& implicit, const SpaceOptions& options);
Json space_implicit_json(const SpaceImplicit& implicit, const SpaceOptions& options);
/// Both projections with the zero sets of f and g.
std::string space_implicit_svg(const SpaceImplicit& implicit, const BezierCurve& curve,
                               const std::string& title);

}  // namespace exsect::cli
