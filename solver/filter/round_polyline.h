// Polylines of curves on round charts. Internal to solver/; docs/method-equations.md, section 17.21.
#pragma once

#include "filter/round_trace.h"
#include "trace/arc_polyline.h"
#include "trace/bounded_vertex.h"

namespace exsect {

/// The point of space that a box stands for, with its distance from all places in it, and `error` more.
BoundedVertex vertex_at(const RoundChart& chart, const RoundBox& box, double error);

/// Of a trace from landmark to landmark, within the tolerance unless doubles are too rough.
ArcPolyline round_polyline(const RoundChart& chart, const RoundTrace& trace, double tolerance);

}  // namespace exsect
