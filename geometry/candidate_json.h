// The JSON form of candidates. Internal to geometry/.
#pragma once

#include <string>

#include "candidate.h"

namespace exsect {

/// Splines of a higher degree are refused.
inline constexpr int max_spline_degree = 20;

Candidate parse_json_candidate(const std::string& text, const std::string& filename);

}  // namespace exsect
