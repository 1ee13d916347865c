// Following the true curve along a candidate curve. Internal to solver/; docs/method-verify.md, section 15.
#pragma once

#include <exsect/solver/intersection_graph.h>

#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "chain_distances.h"

namespace exsect {

/// One arc of the graph or of the rim of an overlap.
struct TrueArc {
  const Arc* arc;
  int overlap;  // -1: an arc of the graph
};

/// The arcs of a graph as chains; positions along an arc count the pieces of its polyline.
class TrueCurve {
 public:
  explicit TrueCurve(const IntersectionGraph& graph);
  TrueCurve(const TrueCurve&) = delete;
  TrueCurve& operator=(const TrueCurve&) = delete;

  const std::vector<TrueArc>& arcs() const { return arcs_; }
  const std::vector<Chain>& chains() const { return chains_; }
  const PieceTree& tree() const { return tree_; }
  /// (arc, direction) of the arcs that leave the node at which this one ends, itself in reverse left out.
  std::vector<std::pair<std::size_t, int>> after(std::size_t arc, int direction) const;

 private:
  std::vector<TrueArc> arcs_;
  std::vector<Chain> chains_;
  std::map<int, std::vector<std::pair<std::size_t, int>>> leaving_;  // by node
  PieceTree tree_;
};

/// A part of an arc that is run through from one position to another.
struct Leg {
  std::size_t arc;
  int direction;  // +1: from <= to, -1: from >= to
  double from;
  double to;
};

/// A part of a candidate chain, between two of its vertices, matched to a path on the true curve: both run
/// forward, and matched points are nowhere farther apart than `distance` (proved).
struct Walk {
  std::size_t first;  // vertices of the chain
  std::size_t last;
  std::vector<Leg> legs;
  double distance;
  /// The same path, and at its ends what is within the tolerance of the first and of the last vertex.
  std::vector<Leg> reach;
};

struct WalkSearch {
  double tolerance;  // matched points are at most this far apart
  double rounding;   // bound of the error of a computed distance
  /// Preferred, the smaller the better, where a walk could take one or another arc equally well.
  std::function<double(std::size_t arc, double position, std::size_t vertex)> rank;
  /// Added to the rank of the place where a walk starts.
  std::function<double(const Walk&)> rank_of_walk;
  StopRequest stop;
};

/// Maximal walks along a chain, one after the other: a vertex that is on none is where no walk could start.
/// Throws Interrupted.
std::vector<Walk> find_walks(const TrueCurve& truth, const Chain& chain, const WalkSearch& search);

}  // namespace exsect
