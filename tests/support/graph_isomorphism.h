// Equality of two intersection graphs up to renaming of nodes, arcs, components and parameters.
#pragma once

#include <exsect/solver/intersection_graph.h>

#include <array>
#include <string>

namespace exsect {

/// Parameter i of the first graph is parameter to[i] of the second, which runs the other way if reversed[i].
struct Renaming {
  std::array<std::size_t, 4> to = {0, 1, 2, 3};
  std::array<bool, 4> reversed = {false, false, false, false};
};

/// Empty if the graphs are equal: nodes of the same kinds, sides and free parameters with overlapping boxes
/// in bijection; arcs between corresponding nodes in bijection, with the same free parameters, whose
/// polylines run together to within `tolerance` in the parameters; components of the same shape, isolated
/// points, overlaps with the same chains. Otherwise the first difference in words.
std::string difference(const IntersectionGraph& a, const IntersectionGraph& b, const Renaming& renaming,
                       double tolerance = 1e-3);

}  // namespace exsect
