// How often a traced curve meets a fibre. Internal to solver/.
#pragma once

#include <cstddef>
#include <optional>

#include "answer/graph_builder.h"
#include "sweep/sweep_data.h"
#include "trace/trace_graph.h"

namespace exsect {

/// How often the curve meets the sample of the sweep parameter; empty if an end or turning point cannot be
/// told from it. Between these the curve is monotone in the sweep parameter. Requires sweep.turning.
template <class Ball>
std::optional<std::size_t> crossings(const SweepData& sweep, const AnalysedTrace<Ball>& curve,
                                     const Rational& sample);

}  // namespace exsect
