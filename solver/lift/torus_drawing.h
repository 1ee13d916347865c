// A curve on a torus in numbers: boxes of its nodes, polylines of its arcs, names. Internal to solver/;
// docs/method-equations.md, sections 17.4 and 17.10.
#pragma once

#include <vector>

#include "curve/curve_course.h"
#include "lift/lifted_course.h"
#include "lift/surface_intersection.h"
#include "lift/torus_curve.h"

namespace exsect {

/// Refers to the curve. Not to be shared by threads.
class TorusDrawing {
 public:
  /// Polylines keep within the tolerance, a length above 0. Throws BeyondDoubles if the torus lies beyond the
  /// range of doubles.
  TorusDrawing(const TorusCurve& curve, double tolerance);

  /// A closed box around the node, of no other node over the same parameter of its patch.
  SpaceBox box(std::size_t node) const;
  /// From the arc's first node to the last one.
  SpaceCourse course(std::size_t arc) const;

 private:
  struct Part {
    DrawnPatch patch;
    std::vector<NodePlace> places;  // of all nodes of its graph
  };

  const TorusCurve& curve_;
  double tolerance_;
  std::vector<Part> parts_;
};

/// The largest diameter of the torus, for tolerances.
double extent_of(const TorusFrame& torus);

/// As for lifted curves: ids are positions, the arcs are those of the curve, each in one of them; is_closed
/// is not set. Circles about the axis and in planes through it are named.
std::vector<SpaceCurve> named_curves(const TorusCurve& curve);

}  // namespace exsect
