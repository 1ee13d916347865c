// Nodes and arcs of a plane curve in numbers: small boxes of nodes, and the v of an arc over a rational u.
// Internal to solver/; docs/method-equations.md, section 17.4.
#pragma once

#include <exsect/solver/curve_graph.h>

#include <array>
#include <optional>

namespace exsect {

/// The range of an arc in u that is no part of a line u = const: columns first to last.
struct ArcColumns {
  std::size_t first;
  std::size_t last;
};
std::vector<std::optional<ArcColumns>> columns_of_arcs(const CurveGraph& graph);

/// A closed interval around v of the arc over u; of width at most `width`, the number itself if it is known
/// to be rational. Empty if u is in the closed interval of a critical value or the arc does not pass over it.
std::optional<RationalInterval> arc_over(const CurveGraph& graph, std::size_t arc, const Rational& u,
                                         const Rational& width);

/// Closed intervals (u,v) around the node, about as small as `width`, with no other point of the curve over
/// its u; the number itself where it is known to be rational.
std::array<RationalInterval, 2> place_of(const CurveGraph& graph, std::size_t node, const Rational& width);

}  // namespace exsect
