// The maker of results: the graph is finished and checked, and the status follows. Internal to solver/.
#pragma once

#include <exsect/solver/result.h>

#include <functional>
#include <string>
#include <vector>

#include "answer/graph_builder.h"
#include "answer/run.h"

namespace exsect {

/// Complete if `incomplete` is empty and the graph keeps its invariant, see graph_invariant.h. Otherwise a
/// violation is a place that is not decided. To be called with all that is known to be undecided.
IntersectResult finished(GraphBuilder graph, const GraphFacts& facts, std::vector<Incomplete> incomplete,
                         Work work = {});

/// What `solve` returns; without a graph if the time of the call is over in the middle of one long
/// computation. Where it throws a ProofFailure, or another std::logic_error than std::invalid_argument, a
/// result without a graph says where and why.
IntersectResult answered(const Run& run, const std::function<IntersectResult()>& solve);

/// No graph, and why.
IntersectResult undecided(const ParameterBox& where, std::string why, Reason reason = Reason::not_decided);

}  // namespace exsect
