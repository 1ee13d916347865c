// Regions of parameters over which the solutions lie on a graph. Internal to solver/; docs/method.md,
// section 6.3.
#pragma once

#include <array>
#include <optional>

#include "trace/pair_system.h"
#include "trace/subdivision.h"

namespace exsect {

/// Proved by (6.2): for every point (u,v) of two intervals A there is exactly one (r,s) in `range` with
/// C(x(u,v) - y(r,s)) = 0, in the interior; C y' is regular there and y injective. So all solutions with
/// (u,v) in A and (r,s) in `range` lie on a graph over A.
struct SheetGraph {
  std::array<RationalInterval, 2> range;             // of r and s; may reach beyond [0,1]
  std::array<std::array<double, 3>, 2> combination;  // C
  /// For fixed (u,v) the map b -> b + C(x - y(b)) contracts distances in `range` by this factor, in the norm
  /// max |b_k| / width_k.
  std::array<double, 2> width;
  double contraction;
};

/// Over the first two intervals of the region, near the middle of the last two; empty if it is not proved.
std::optional<SheetGraph> graph_over(const PairSystem<DoubleBall>& system, const SearchRegion& region);

}  // namespace exsect
