// Many pairs of patches at once, on as many threads as the caller asks for.
#pragma once

#include <exsect/solver/intersect.h>

#include <span>
#include <vector>

namespace exsect {

struct PatchPair {
  BezierPatch x;
  BezierPatch y;
};

/// intersect() of every pair, in their order, on `threads` threads, at most one for each processor; only here
/// does the library start any, and only for threads > 1. Results do not depend on their number, up to `work`.
/// The first exception that is thrown ends the work and is passed on; `progress` of the options may be called
/// from several threads. Throws std::invalid_argument for threads < 1.
std::vector<IntersectResult> intersect_all(std::span<const PatchPair> pairs,
                                           const IntersectOptions& options = {}, int threads = 1);

}  // namespace exsect
