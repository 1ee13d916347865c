// The results of `exsect intersect` and `exsect self` as JSON, forms "intersection/1" and "self/1".
#pragma once

#include <exsect/solver/result.h>

#include <string>

#include "output/text/json_forms.h"

namespace exsect::cli {

/// Names of the two patches, in the order of the parameters (u,v) and (r,s), and what the parameters are
/// called. Where the second is a surface given by its equation `equation` is its kind, as "torus".
struct PatchNames {
  std::string first;
  std::string second;
  ParameterNames parameters = pair_names;
  std::string equation = {};
};

/// Deterministic but for "work": keys in the order of docs/formats.md, nodes, arcs and components by id.
/// Exact rationals are strings; doubles carry enough digits to be read back unchanged, error bounds are never
/// rounded down.
Json intersection_json(const IntersectResult& result, const PatchNames& names);
/// The same for a patch and itself: one patch name, parameters u1, v1, u2, v2.
Json self_json(const IntersectResult& result, const std::string& patch);

/// The parts `summary` and `incomplete` of a result.
Json summary_json(const IntersectionGraph& graph, const ParameterNames& names);
Json incomplete_json(const std::vector<Incomplete>& incomplete, const ParameterNames& names);

}  // namespace exsect::cli
