// From traced curves along which the patches touch to arcs with polylines. Internal to solver/.
#pragma once

#include "trace/contact_turning.h"
#include "trace/trace_graph.h"

namespace exsect {

template <class Ball>
using AnalysedContact = AnalysedCurve<Ball, TangentialTube<Ball>>;

/// Appends the arcs of one curve, with contact `tangential`, and its turning nodes with respect to `wanted`
/// parameters (a closed curve without any gets all). `ends` and `landmarks` are indexed as
/// TangentialArc::start. Polylines keep within `tolerance` (space units) of the curve where doubles can
/// express that; Arc::error_bound is what is proved.
template <class Ball>
void append_contact(GraphBuilder& graph, const PairSystem<Ball>& system, const AnalysedContact<Ball>& contact,
                    const Landmarks<Ball>& landmarks, const std::vector<TraceEnd>& ends,
                    const ModelFrame& frame, const std::vector<Parameter>& wanted, double tolerance);

}  // namespace exsect
