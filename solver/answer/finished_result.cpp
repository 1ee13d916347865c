#include "answer/finished_result.h"

#include <utility>

namespace exsect {

IntersectResult finished(GraphBuilder graph, const GraphFacts& facts, std::vector<Incomplete> incomplete,
                         Work work) {
  FinishedGraph made = std::move(graph).finish(facts);
  if (incomplete.empty()) incomplete = std::move(made.violations);
  const Status status = incomplete.empty() ? Status::complete : Status::incomplete;
  return {status, std::move(made.graph), std::move(incomplete), std::move(work)};
}

IntersectResult undecided(const ParameterBox& where, std::string why, Work work) {
  return {Status::incomplete, {}, {{where, std::move(why)}}, std::move(work)};
}

}  // namespace exsect
