// A result with other polylines, drawn from what was proved.
#pragma once

#include <exsect/solver/result.h>

#include <functional>
#include <optional>

namespace exsect {

struct RedrawOptions {
  double tolerance = 1e-6;  // as IntersectOptions::tolerance
  /// Work cap, in place of the one of the call that gave the result.
  std::optional<double> max_seconds = {};
  std::function<void(double, const char*)> progress = {};
};

/// The result at another tolerance: the same nodes and arcs, in the same order, with other polylines, error
/// bounds and `coarse`. What was proved is drawn again. Only where it is too rough for the tolerance, or
/// where a method keeps nothing, the call is made again, with its options but for these; then boxes of nodes
/// may be narrower. At the tolerance of the call the graph is the same, number for number. `work` is that of
/// the drawing. Safe to call from several threads. Throws std::invalid_argument for options out of range, as
/// intersect() does, and for a result that is none of intersect() or self_intersect().
IntersectResult redrawn(const IntersectResult& result, const RedrawOptions& options);

}  // namespace exsect
