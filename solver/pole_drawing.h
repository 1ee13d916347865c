// How arcs that begin in a pole are drawn within a tolerance. Internal to solver/; docs/method-doubles.md,
// section 14.24.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/intersection_graph.h>

#include <functional>
#include <optional>
#include <vector>

#include "answer/run.h"
#include "special/pole_arcs.h"

namespace exsect {

/// What is proved over 0 < a <= reach: all arcs, along which these parameters of (a,t,r,s) as (u,v,r,s) are
/// turning.
using ProvedArcs = std::function<std::optional<std::vector<PoleArc>>(const Rational& reach,
                                                                     const std::vector<Parameter>& turning)>;

/// The side (0,t) of x is a point of y, or a whole side of y, which has all of it for its place.
struct PolePair {
  RationalPatch x;
  RationalPatch y;
  PoleOnPatch pole;
  double extent;  // of the model
  ProvedArcs near_pole;
};

/// All arcs over 0 < a <= reach.
struct PoleNeighbourhood {
  Rational reach;
  std::vector<PoleArc> arcs;
};

/// Draws the arcs of one neighbourhood, within the tolerance of the run where smaller neighbourhoods and what
/// is between them are decided. The pair and the run have to outlive it.
class PoleDrawing {
 public:
  PoleDrawing(const PolePair& pair, PoleNeighbourhood all, const Run& run);

  /// The pole with t free, and the parameter along its side of y if it is one.
  Node node() const;
  /// From the pole to the end of arc `which` of the neighbourhood, which was drawn as the vertex `end`.
  Arc arc(std::size_t which, const PolylineVertex& end) const;

 private:
  PolylineVertex pole_vertex() const;
  const PoleArc* continued(const PoleArc& arc, const PoleNeighbourhood& inside) const;
  bool add_piece(const PoleArc& arc, const Rational& from, const Rational& to, Arc& drawn) const;
  void add_ray(const PoleRay& ray, Arc& drawn) const;
  void add_chord(const PoleArc& arc, Arc& drawn) const;

  const PolePair& pair_;
  const Run& run_;
  std::vector<PoleNeighbourhood> levels_;  // from the one that was given to smaller ones
};

}  // namespace exsect
