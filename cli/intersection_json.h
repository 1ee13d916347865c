// The result of `exsect intersect` as JSON, form "intersection/1".
#pragma once

#include <exsect/solver/result.h>

#include <string>

#include "json_forms.h"

namespace exsect::cli {

/// Names of the two patches, in the order of the parameters (u,v) and (r,s).
struct PatchNames {
  std::string first;
  std::string second;
};

/// Deterministic but for "work": keys in the order of docs/formats.md, nodes, arcs and components by id.
/// Exact rationals are strings; doubles carry enough digits to be read back unchanged, error bounds are never
/// rounded down.
Json intersection_json(const IntersectResult& result, const PatchNames& names);

}  // namespace exsect::cli
