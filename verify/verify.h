// What another program computed for a pair of patches, held against the proved intersection.
#pragma once

#include <exsect/geometry/candidate.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>
#include <exsect/verify/verdict.h>

#include <functional>
#include <optional>
#include <vector>

namespace exsect {

/// The verdict from one exact result of the patches, with turning points of all parameters as nodes.
/// `tolerance` > 0 is a length. Throws std::invalid_argument for a candidate that breaks its invariants, or
/// that is more than 2^500 times larger than the patches.
Verdict verify(const Candidate& candidate, const RationalPatch& x, const RationalPatch& y,
               const IntersectResult& exact, double tolerance);

struct VerifyOptions {
  double tolerance = 1e-6;  // relative to the size of the model, as in IntersectOptions
  /// Cap of the work altogether, the exact intersections and the comparison; when it is exceeded what is not
  /// proved until then is undecided.
  std::optional<double> max_seconds;
  std::function<void(double, const char*)> progress;
};

struct Verification {
  Verdict verdict;
  IntersectResult exact;
  /// What `exact` was asked for, relative: intersect() with it gives the same graph, ids included.
  double exact_tolerance;
  /// The parameters whose turning points are nodes of `exact`: all, or none.
  std::vector<Parameter> exact_turning;
};

/// Intersects the patches, with polylines fine enough for the tolerance and finer ones where the verdict
/// needs them; without turning points, which a verdict does not need, where patches with weights or of degree
/// three are complete only so. Throws std::invalid_argument for options out of range, and as above.
Verification verify(const Candidate& candidate, const RationalPatch& x, const RationalPatch& y,
                    const VerifyOptions& options = {});

}  // namespace exsect
