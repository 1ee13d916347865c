// The result of `exsect compare` as JSON, form "comparison/1".
#pragma once

#include "output/text/comparison.h"
#include "output/text/intersection_json.h"

namespace exsect::cli {

/// Keys in the order of docs/formats.md. Times and memory differ from run to run.
Json comparison_json(const Comparison& comparison, const PatchNames& names);

}  // namespace exsect::cli
