#include "answer/redrawn.h"

#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "answer/finished_result.h"
#include "answer/proof.h"

namespace exsect {

namespace {

/// Calls again with what is left of the time.
IntersectResult solved_again(const Proof& proof, IntersectOptions call,
                             std::chrono::steady_clock::time_point start) {
  const std::chrono::duration<double> used = std::chrono::steady_clock::now() - start;
  if (call.max_seconds) call.max_seconds = std::max(*call.max_seconds - used.count(), 1e-9);
  return proof.solve(call);
}

}  // namespace

IntersectResult redrawn(const IntersectResult& result, const RedrawOptions& options) {
  if (!result.proof || !result.proof->solve)
    throw std::invalid_argument("redrawn: the result is none of intersect() or self_intersect()");
  const Proof& proof = *result.proof;
  IntersectOptions call = proof.options;
  call.tolerance = options.tolerance;
  call.max_seconds = options.max_seconds;
  call.progress = options.progress;
  return in_nearest_rounding([&]() -> IntersectResult {
    const auto start = std::chrono::steady_clock::now();
    const Run run(call);
    if (!proof.draw) return proof.solve(call);
    bool is_drawn = true;
    IntersectResult drawn = answered(run, [&] {
      std::optional<IntersectResult> found;
      run.timed("drawing", [&] { found = proof.draw(run); });
      is_drawn = found.has_value();
      return is_drawn ? *std::move(found) : IntersectResult{};
    });
    if (!is_drawn) return solved_again(proof, call, start);
    drawn.proof = result.proof;
    return run.finished(std::move(drawn));
  });
}

}  // namespace exsect
