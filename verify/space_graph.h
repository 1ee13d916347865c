// The intersection of two surfaces given by their equations as a graph without parameters. Internal to
// verify/; docs/method-verify.md, section 15.
#pragma once

#include <exsect/solver/result.h>
#include <exsect/solver/surface_intersection.h>

#include <vector>

namespace exsect {

/// Nodes and arcs with their ids, all parameters 0, and the connected parts as components; arcs along which
/// the surfaces touch are tangential.
IntersectResult graph_in_space(const SurfaceIntersection& found);

/// Of each isolated point, in the order of their nodes: how far it may be from SpaceNode::approx.
std::vector<double> point_bounds(const SurfaceIntersection& found);

/// The largest extent of the box around the polylines and nodes; 0 without any.
double extent_in_space(const SurfaceIntersection& found);

/// The largest error bound of a polyline.
double largest_bound(const SurfaceIntersection& found);

}  // namespace exsect
