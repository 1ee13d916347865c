// The result of `exsect line` as JSON, form "line/1".
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/line_patch.h>

#include "output/text/json_forms.h"

namespace exsect::cli {

/// Deterministic, keys in the order of docs/formats.md. x is the patch of (u,v): it gives the points of
/// space.
Json line_json(const LineIntersection& line, const RationalPatch& x);

}  // namespace exsect::cli
