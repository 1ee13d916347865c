// Pairs of surfaces through a curve of space as text, JSON and picture.
#pragma once

#include <exsect/implicit/implicitize_space_curve.h>

#include <array>
#include <string>
#include <vector>

#include "output/text/implicit_json.h"

namespace exsect::cli {

/// The axes other than that of the parameter, ascending: those of the projections.
std::array<int, 2> other_axes(const SpaceImplicit& implicit);

/// What is proved and what is not.
PlanarStatements space_statements(const SpaceImplicit& implicit);
/// The projections are exact or their distances are bounded, and so is the angle.
bool is_complete(const SpaceImplicit& implicit);

std::string space_implicit_summary(const SpaceImplicit& implicit, const SpaceOptions& options);
Json space_implicit_json(const SpaceImplicit& implicit, const SpaceOptions& options);

}  // namespace exsect::cli
