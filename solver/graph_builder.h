// From traced curves to nodes, arcs with polylines, and components. Internal to solver/.
#pragma once

#include <exsect/solver/intersection_graph.h>
#include <exsect/solver/result.h>

#include <optional>
#include <vector>

#include "turning_points.h"

namespace exsect {

/// The translation and scaling of PairSystem: a space point is origin + 2^exponent * (scaled point). The
/// origin has double coordinates.
struct ModelFrame {
  std::array<double, 3> origin;
  long exponent;
};

/// A traced curve with all its turning points, in order, and where else its arcs are cut.
template <class Ball>
struct AnalysedTrace {
  Trace<Ball> trace;
  TurningPoints<Ball> turning;
  std::vector<TraceCut> cuts = {};
};

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

/// The node of a point on the given sides (none: inside); `box` encloses its parameters.
template <class Ball>
Node landmark_node(const PairSystem<Ball>& system, const ModelFrame& frame, const BallPoint<Ball>& ball,
                   const ParameterBox& box, const std::vector<Side>& sides);

/// How an arc goes on from the port of a star to the star's node: vertices in between, and a bound of the
/// distance between the arc and the chords.
struct Approach {
  std::vector<PolylineVertex> vertices;
  double bound;
};

/// Where the traces that end at a landmark lead to.
struct TraceEnd {
  int node;
  std::optional<Approach> approach;  // the landmark is a port
};

/// Node i for landmark i.
std::vector<TraceEnd> nodes_of_landmarks(std::size_t count);

/// Appends the arcs of one trace and its turning nodes with respect to `wanted` parameters (a closed curve
/// without any gets all its turning nodes). `ends` and `landmarks` are indexed as Trace::start. Polylines
/// keep within `tolerance` (space units) of the curve where doubles can express that; Arc::error_bound is
/// what is proved.
template <class Ball>
void append_trace(IntersectionGraph& graph, const AnalysedTrace<Ball>& curve,
                  const Landmarks<Ball>& landmarks, const std::vector<TraceEnd>& ends,
                  const ModelFrame& frame, const std::vector<Parameter>& wanted, double tolerance);

/// If the arc's polyline is not proved to keep within `tolerance` (space units): where it starts, and that.
std::optional<Incomplete> too_coarse(const IntersectionGraph& graph, const Arc& arc, double tolerance);

/// Fills in components from nodes and arcs, and drops the nodes that no arc, no isolated point and no
/// overlap names.
void finish_components(IntersectionGraph& graph);

}  // namespace exsect
