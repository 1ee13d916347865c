#include "answer/proof.h"

#include <utility>

namespace exsect {

std::optional<IntersectResult> first_drawn(Draw draw, const Run& run) {
  std::optional<IntersectResult> result = draw(run);
  if (result) result->proof = std::make_shared<const Proof>(Proof{std::move(draw), {}, {}});
  return result;
}

IntersectResult changed(IntersectResult other, const Run& run, ResultChange change, OtherRun other_run) {
  const std::shared_ptr<const Proof> proof = std::exchange(other.proof, nullptr);
  change(other, run);
  if (!proof || !proof->draw) return other;
  Draw draw = [of_other = proof->draw, change = std::move(change),
               other_run = std::move(other_run)](const Run& again) {
    std::optional<IntersectResult> result = of_other(other_run(again));
    if (result) change(*result, again);
    return result;
  };
  other.proof = std::make_shared<const Proof>(Proof{std::move(draw), {}, {}});
  return other;
}

IntersectResult answer_to(const IntersectOptions& options, IntersectResult result, Solve solve) {
  Proof proof{result.proof ? result.proof->draw : Draw(), options, std::move(solve)};
  proof.options.progress = {};
  result.proof = std::make_shared<const Proof>(std::move(proof));
  return result;
}

}  // namespace exsect
