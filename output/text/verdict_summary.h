// A verdict on a candidate as text for a reader.
#pragma once

#include <exsect/geometry/candidate.h>
#include <exsect/verify/verify.h>

#include <array>
#include <string>

namespace exsect::cli {

/// The verdict with the tolerance that was asked for (`asked`, relative to the model) and the length that it
/// is, the largest proved distance, one line for each difference with the vertices and a place near it, what
/// is not decided, and tables of the components and the curves. The patches are those of (u,v) and (r,s),
/// nullptr for surfaces given by their equations.
std::string verdict_summary(const Verification& verification, const Candidate& candidate,
                            const std::string& asked, const std::array<const RationalPatch*, 2>& patches);

}  // namespace exsect::cli
