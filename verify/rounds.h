// Exact results with finer and finer polylines until a verdict is decided. Internal to verify/;
// docs/method-verify.md, section 15.
#pragma once

#include <exsect/solver/options.h>
#include <exsect/verify/verify.h>

#include <functional>

#include "verifier.h"

namespace exsect {

/// What is asked of one candidate.
struct VerifyQuestion {
  /// Of the model, a length; 0 for a point.
  std::function<double(const IntersectResult&)> extent;
  std::function<IntersectResult(const IntersectOptions&)> solve;
  std::function<Verdict(const IntersectResult&, double tolerance, const StopRequest&)> judge;
  /// A result that is incomplete with turning points as nodes may be complete without them.
  bool may_drop_turning = false;
};

/// The question is solved once, and its result redrawn for each further round, of three at most. A quarter
/// of the time that is left is kept for comparing.
Verification verified(const VerifyQuestion& question, const VerifyOptions& options);

}  // namespace exsect
