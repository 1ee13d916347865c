// Properties that every intersection graph has, checked without knowing the answer. They are written for
// pairs in special position: where a check decides nothing it says nothing.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/result.h>

#include <string>

namespace exsect {

/// The first property violated, in words, or empty. Of any result: every node's box lies in the domain, is a
/// point at the sides named, and x - y, bounded exactly, can vanish in it; the vertices of every arc lie on
/// both patches within its bound; arcs end at nodes; the components are those of the arcs, with their shapes.
std::string unsound(const BezierPatch& x, const BezierPatch& y, const IntersectResult& result);

/// Of a complete result: what is found by other means and missing in it, or in it and not found; or empty.
/// These are the exact coincidences x(u,v) = y(r,s) at parameters in {0, 1/3, 1/2, 2/3, 1}, and the solutions
/// on a few parameter lines, which the arcs have to meet one to one where the oracle has no doubt.
struct Comparison {
  std::string difference;
  int coincidences = 0;  // compared
  int lines = 0;         // of 12
};
Comparison compare_with_oracle(const BezierPatch& x, const BezierPatch& y, const IntersectionGraph& graph);

}  // namespace exsect
