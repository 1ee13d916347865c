// Following the curve of an equation on a patch by tubes. Internal to solver/; docs/method-equations.md,
// section 17.22.
#pragma once

#include <optional>
#include <vector>

#include "filter/section_tube.h"
#include "trace/tube_trace.h"

namespace exsect {

using SectionTrace = TubeTrace<SectionTube, SectionBox>;

/// From landmark `start` on, with f > 0 to the left, to the next landmark. Empty if doubles do not prove it.
std::optional<SectionTrace> section_trace(const SquareForm& f, const std::vector<SectionLandmark>& landmarks,
                                          std::size_t start, const StopRequest& stop);

/// 1 if the curve with f > 0 to its left goes into the square at the landmark, on its side, or begins an arc
/// inside of it; -1 if it goes out; 0 if that is not known.
int section_direction(const SquareForm& f, const SectionLandmark& landmark);

}  // namespace exsect
