// The intersection of two surfaces given by their equations as text and as JSON, form "surfaces/1".
#pragma once

#include <exsect/solver/surface_intersection.h>

#include <string>

#include "output/text/json_forms.h"

namespace exsect::cli {

/// The names of the surfaces and of their kinds, as in files.
struct SurfaceNames {
  std::string first;
  std::string second;
  std::string first_kind;
  std::string second_kind;
};

/// Deterministic but for `work`, keys in the order of docs/formats.md.
Json surfaces_json(const SurfaceIntersection& result, const SurfaceNames& names);
/// "2 ellipses, 2 crossings", "nothing in common", "one surface".
std::string what_is_common(const SurfaceIntersection& result);
/// "first:sector=from second:height=to": the bounds of which surfaces a node lies on; empty if it is on none.
std::string bounds_text(const SpaceNode& node);
std::string surfaces_summary(const SurfaceIntersection& result, const SurfaceNames& names, bool verbose);

}  // namespace exsect::cli
