#include "rounds.h"

#include <exsect/solver/redrawn.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace exsect {

Verification verified(const VerifyQuestion& question, const VerifyOptions& options) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const auto left = [&] {
    return *options.max_seconds - std::chrono::duration<double>(Clock::now() - start).count();
  };
  const StopRequest stop = options.max_seconds ? StopRequest([&] { return left() <= 0; }) : StopRequest();
  IntersectOptions fine;
  fine.progress = options.progress;
  constexpr int most_rounds = 3;
  IntersectResult exact{};
  for (int round = 1;; ++round) {
    fine.tolerance = std::ldexp(options.tolerance, -1 - 3 * round);
    if (options.max_seconds) fine.max_seconds = std::max(0.75 * left(), 1e-9);  // the rest to compare
    exact = exact.proof ? redrawn(exact, {fine.tolerance, fine.max_seconds, fine.progress})
                        : question.solve(fine);
    if (exact.status == Status::incomplete && question.may_drop_turning && !fine.turning.empty() &&
        !is_stopped(stop)) {
      fine.turning = {};
      exact.proof = nullptr;
      --round;
      continue;
    }
    const double extent = question.extent(exact);
    const double tolerance = options.tolerance * (extent > 0 ? extent : 1);
    Verdict verdict = question.judge(exact, tolerance, stop);
    if (verdict.agreement != Agreement::undecided || !verdict.exact_is_complete || round == most_rounds ||
        is_stopped(stop))
      return {std::move(verdict), std::move(exact), fine.tolerance, fine.turning};
  }
}

}  // namespace exsect
