// Nodes with a free parameter, as certificates have them: with all their solutions.
#pragma once

#include <exsect/solver/intersection_graph.h>

namespace exsect::cli {

/// The graph in the four parameters: a node with one free parameter becomes the arcs along which this one
/// runs from 0 to 1 while the point of space stays, with nodes where other arcs reach them.
IntersectionGraph with_free_arcs(IntersectionGraph graph);

}  // namespace exsect::cli
