#include "answer/finished_result.h"

#include <exsect/algebra/interruption.h>

#include <stdexcept>
#include <utility>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"

namespace exsect {

IntersectResult finished(GraphBuilder graph, const GraphFacts& facts, std::vector<Incomplete> incomplete,
                         Work work) {
  FinishedGraph made = std::move(graph).finish(facts);
  if (incomplete.empty()) {
    incomplete = std::move(made.violations);
    for (Incomplete& violation : incomplete) violation.reason = Reason::failed_proof;
  }
  const Status status = incomplete.empty() ? Status::complete : Status::incomplete;
  return {status, std::move(made.graph), std::move(incomplete), std::move(work)};
}

IntersectResult answered(const Run& run, const std::function<IntersectResult()>& solve) {
  const InterruptionScope scope(run.stop());
  try {
    return solve();
  } catch (const Interrupted&) {
    return undecided(whole_domain(), "the work cap was reached", Reason::time);
  } catch (const ProofFailure& failure) {
    return undecided(failure.where(), failure.what(), Reason::failed_proof);
  } catch (const std::invalid_argument&) {
    throw;
  } catch (const std::logic_error& error) {
    return undecided(whole_domain(), std::string("a proof failed: ") + error.what(), Reason::failed_proof);
  }
}

IntersectResult undecided(const ParameterBox& where, std::string why, Reason reason) {
  return {Status::incomplete, {}, {{where, std::move(why), reason}}, {}};
}

}  // namespace exsect
