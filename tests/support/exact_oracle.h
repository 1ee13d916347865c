// A second opinion on x(u,v) = y(r,s), for patches of every bidegree with weights or without, by integers
// alone: Bernstein coefficients and halving. It shares nothing with the solver; what it does not decide it
// says.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/intersection_graph.h>

#include <string>
#include <vector>

namespace exsect::exact_oracle {

/// The solutions on one parameter line, in disjoint closed boxes of [0,1]^4 with one solution each: proved,
/// unless `doubt` says why not: contact of line and patch, a solution on a side or next to one.
struct LinePoints {
  std::vector<ParameterBox> points;
  std::string doubt;

  bool conclusive() const { return doubt.empty(); }
};
/// Parameter i (0 to 3 for u, v, r, s) has this value, in [0,1].
LinePoints line_points(const RationalPatch& x, const RationalPatch& y, std::size_t i, const Rational& value);

/// True only if no point of the one part of x is one of the part of y over the other two intervals of the
/// box.
bool proved_apart(const RationalPatch& x, const RationalPatch& y, const ParameterBox& box);

/// Of a complete graph without overlaps whose turning points are nodes: what contradicts it, or is empty. The
/// arcs over a line are its solutions one to one; no vertex of an arc is where the patches are proved apart;
/// and what is not proved apart lies next to the graph.
struct Comparison {
  std::string difference;
  int lines = 0;     // decided, of 8
  int vertices = 0;  // looked at
  int unsure = 0;    // cells away from the graph that are not proved to be apart
};
Comparison compare(const RationalPatch& x, const RationalPatch& y, const IntersectionGraph& graph);

}  // namespace exsect::exact_oracle
