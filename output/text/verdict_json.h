// A verdict on a candidate as JSON, form verdict/1 (docs/formats.md).
#pragma once

#include <exsect/geometry/candidate.h>
#include <exsect/verify/verify.h>

#include "output/text/intersection_json.h"

namespace exsect::cli {

/// The verdict on a candidate for patches of these names.
Json verdict_json(const Verification& verification, const Candidate& candidate, const PatchNames& names);

}  // namespace exsect::cli
