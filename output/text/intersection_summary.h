// The result of `exsect intersect` as text for a reader.
#pragma once

#include <exsect/solver/result.h>

#include <string>

#include "output/text/intersection_json.h"

namespace exsect::cli {

/// Status, components, nodes, arcs, times and what is not known, ending with a line feed.
std::string intersection_summary(const IntersectResult& result, const PatchNames& names);

}  // namespace exsect::cli
