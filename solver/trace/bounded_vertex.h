// Vertices of polylines with bounds of their errors, and bounds for the chords between them. Internal to
// solver/.
#pragma once

#include <exsect/solver/intersection_graph.h>

#include "answer/model_scale.h"
#include "trace/pair_system.h"

namespace exsect {

/// A bound of the distance between any arc of the intersection in a parameter box and any chord between
/// vertices that stand for points of it.
template <class Ball>
double chord_bound(const PairSystem<Ball>& system, const ModelFrame& frame, const ParameterBox& box);

/// A vertex and a bound of its distance from the curve point it stands for.
struct BoundedVertex {
  PolylineVertex vertex;
  double error;
};
/// The vertex at a position in space, enclosed in the scaled system; its parameters are left to the caller.
template <class Ball>
BoundedVertex bounded_position(const BallVector<Ball>& position, const ModelFrame& frame);
/// The vertex of a point enclosed by its parameters and, in the scaled system, its position in space.
template <class Ball>
BoundedVertex bounded_vertex(const BallPoint<Ball>& parameters, const BallVector<Ball>& position,
                             const ModelFrame& frame);

}  // namespace exsect
