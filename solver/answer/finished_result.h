// The maker of results: the graph is finished and checked, and the status follows. Internal to solver/.
#pragma once

#include <exsect/solver/result.h>

#include <string>
#include <vector>

#include "answer/graph_builder.h"

namespace exsect {

/// Complete if `incomplete` is empty and the graph keeps its invariant, see graph_invariant.h. Otherwise a
/// violation is a place that is not decided. To be called with all that is known to be undecided.
IntersectResult finished(GraphBuilder graph, const GraphFacts& facts, std::vector<Incomplete> incomplete,
                         Work work = {});

/// No graph, and why.
IntersectResult undecided(const ParameterBox& where, std::string why, Work work = {});

}  // namespace exsect
