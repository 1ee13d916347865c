// The points of a plane curve where v has an extremum along it. Internal to solver/;
// docs/method-equations.md, section 17.4.
#pragma once

#include <exsect/solver/curve_graph.h>

namespace exsect {

/// The same curve with more nodes: the regular points inside the square, on no line u = const of it, where v
/// has a local extremum along an arc. Each has one arc from smaller and one from greater u, and
/// CurveNode::exact is empty. Every arc is monotone in v afterwards.
CurveGraph with_turning_in_v(CurveGraph graph);

}  // namespace exsect
