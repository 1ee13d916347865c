// Limits and closed curves of the searches in charts of pairs. Internal to solver/.
#pragma once

#include <exsect/algebra/ball.h>

#include <utility>
#include <variant>

#include "trace/tracer.h"

namespace exsect {

/// The boxes a search in one chart may look at.
template <class Ball>
constexpr long kMostChartBoxes = 60000;
template <>
inline constexpr long kMostChartBoxes<ArbBall<256>> = 4000;

/// Traces closed curves through points that a search has found, until too many of them have failed.
template <class Ball>
class LoopSeeds {
 public:
  /// True only if a closed curve runs through the pair and `add`, which is given it, returns true.
  template <class Add>
  bool trace(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks, const BallPoint<Ball>& pair,
             const StopRequest& stop, const Add& add) {
    if (failed_ >= kMostFailed) return false;
    auto outcome = trace_loop(system, landmarks, pair, stop);
    if (std::holds_alternative<TraceFailure>(outcome)) {
      ++failed_;
      return false;
    }
    return add(std::move(outcome));
  }

 private:
  static constexpr int kMostFailed = 8;
  int failed_ = 0;
};

}  // namespace exsect
