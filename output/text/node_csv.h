// Nodes as comma-separated values: a table for spreadsheets and statistics programs.
#pragma once

#include <exsect/solver/line_patch.h>
#include <exsect/solver/result.h>
#include <exsect/solver/surface_intersection.h>

#include <string>

#include "output/text/parameter_names.h"

namespace exsect::cli {

/// A row of names, then one for each node: id, kinds, on, wrt and free (several with a blank between them),
/// the ends of the box of each parameter as exact rationals, and the approximate parameters and point.
std::string node_csv(const IntersectionGraph& graph, const ParameterNames& names);

/// The same for the isolated points of a parameter line: id, on, multiplicity and branch, boxes, approximate
/// values; x is the patch of (u,v).
std::string point_csv(const LineIntersection& line, const RationalPatch& x);

/// The same for two surfaces given by their equations: id, kind, arcs (the number of ends of arcs), the ends
/// of the box of each coordinate as exact rationals, and the approximate point.
std::string space_node_csv(const SurfaceIntersection& result);

}  // namespace exsect::cli
