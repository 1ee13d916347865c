// Polylines of curves on round charts. Internal to solver/; docs/method-equations.md, section 17.21.
#pragma once

#include "filter/round_trace.h"
#include "trace/arc_polyline.h"

namespace exsect {

/// Of a trace from landmark to landmark, within the tolerance unless doubles are too rough.
ArcPolyline round_polyline(const RoundChart& chart, const RoundTrace& trace, double tolerance);

}  // namespace exsect
