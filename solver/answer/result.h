// What an intersection run returns: complete, or incomplete with place and reason. There is no third answer.
#pragma once

#include <exsect/solver/incomplete.h>
#include <exsect/solver/intersection_graph.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace exsect {

enum class Status { complete, incomplete };

/// What was proved, for redrawn(). Immutable; it owns all that it refers to.
struct Proof;

/// Milliseconds spent and counts of steps ("tubes", "fibres", ...), for reports and benchmarks.
struct Work {
  double milliseconds = 0;
  std::map<std::string, double> steps;
};

/// As lengths: the tolerance, and the largest error bound of an arc, on rims of overlaps too, which is above
/// it. The bound is infinite if a coordinate is beyond the range of doubles.
struct CoarseDrawing {
  double tolerance;
  double bound;
};

/// complete: the graph is the whole intersection, proved. incomplete: the graph holds what is proved and
/// `incomplete` says what is not known, and why.
struct IntersectResult {
  Status status;
  IntersectionGraph graph;
  std::vector<Incomplete> incomplete;
  Work work;
  /// Polylines do not all keep within the tolerance, because doubles cannot write or draw them that finely.
  /// It does not make the result incomplete: nodes, arcs and their parameters are proved all the same.
  std::optional<CoarseDrawing> coarse = {};
  /// Shared by copies, and by what is drawn from it.
  std::shared_ptr<const Proof> proof = {};
};

}  // namespace exsect
