// The course of an arc of a plane curve: chords of the parameter square with proved strips around them.
// Internal to solver/; docs/method-equations.md, section 17.4.
#pragma once

#include <exsect/solver/curve_graph.h>

#include <array>
#include <optional>
#include <vector>

#include "curve/drawn_patch.h"

namespace exsect {

/// Points (u,v) of the square, and a bound of the distance in space between the curve of the patch over the
/// arc and the polyline through their `points`, both ways.
struct CurveCourse {
  std::vector<std::array<double, 2>> parameters;
  std::vector<std::array<double, 3>> points;
  double error_bound;
};

/// A node in numbers: closed intervals of u and v.
using NodePlace = std::array<RationalInterval, 2>;

/// How small the places of the nodes have to be for courses that keep within `tolerance` (a length, > 0).
Rational place_width(const DrawnPatch& patch, double tolerance);

/// From places[arcs[arc].from] to places[arcs[arc].to]. Throws ProofFailure where numbers of 1024 bits do not
/// suffice.
CurveCourse curve_course(const CurveGraph& graph, const std::vector<NodePlace>& places, std::size_t arc,
                         const DrawnPatch& patch, double tolerance);

/// The segment of the parameter square between two nodes.
CurveCourse straight_course(const NodePlace& from, const NodePlace& to, const DrawnPatch& patch,
                            double tolerance);

}  // namespace exsect
