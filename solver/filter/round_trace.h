// Following the curve on a round chart by tubes. Internal to solver/; docs/method-equations.md,
// section 17.21.
#pragma once

#include <optional>
#include <vector>

#include "filter/round_tube.h"
#include "trace/tube_trace.h"

namespace exsect {

using RoundTrace = TubeTrace<RoundTube, RoundBox>;

/// From landmark `start` on, in the direction of (f_1, -f_0), to the next landmark. The tubes refer to the
/// chart. Empty if doubles do not prove it.
std::optional<RoundTrace> round_trace(const RoundChart& chart, const std::vector<RoundBox>& landmarks,
                                      std::size_t start);

}  // namespace exsect
