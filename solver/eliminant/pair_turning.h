// The turning eliminants of a pair, each computed at most once. Internal to solver/; docs/method.md,
// section 4.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <optional>

#include "answer/stop_request.h"
#include "eliminant/critical_values.h"

namespace exsect {

/// What the turning eliminants tell of a pair: lazily, and kept, for whoever asks in one call of intersect().
/// Both patches must outlive it. Not to be shared by threads.
class PairTurning {
 public:
  PairTurning(const BezierPatch& x, const BezierPatch& y) : x_(x), y_(y) {}

  /// choose_sweep of the pair; `stop` counts on the first call alone.
  const SweepChoice& choice(const StopRequest& stop = {});

  /// turning_values of the sweep along p; nullptr if they have not been computed and `may_compute` is false.
  const std::optional<TurningValues>* values(Parameter p, bool may_compute = true);

 private:
  const BezierPatch& x_;
  const BezierPatch& y_;
  std::optional<SweepChoice> choice_;
  std::array<std::optional<std::optional<TurningValues>>, 4> values_;  // outer: computed
};

}  // namespace exsect
