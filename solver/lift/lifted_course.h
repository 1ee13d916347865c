// Where the nodes and arcs of a lifted curve are in space: boxes, and polylines with proved bounds. Internal
// to solver/; docs/method-equations.md, section 17.6.
#pragma once

#include <array>
#include <vector>

#include "lift/exact_chart.h"
#include "lift/lifted_curve.h"

namespace exsect {

/// A closed box of the point, as narrow in u and v as asked for; > 0.
SpaceBox place_in_space(const LiftedCurve& curve, std::size_t node, const Rational& width);

/// Points of space, and a bound of the distance between the arc and the polyline through them, both ways.
struct SpaceCourse {
  std::vector<std::array<double, 3>> points;
  double error_bound;
};

/// The larger one of the lengths of along_u and along_v.
double extent_of(const SurfaceChart& chart);

/// From node arc.from to node arc.to, within the tolerance (a length, > 0) where doubles reach it.
SpaceCourse course_in_space(const LiftedCurve& curve, std::size_t arc, double tolerance);

}  // namespace exsect
