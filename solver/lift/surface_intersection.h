// All common points of two surfaces given by their equations, with the names of the curves that have one.
#pragma once

#include <exsect/algebra/rational.h>
#include <exsect/geometry/point.h>
#include <exsect/solver/incomplete.h>
#include <exsect/solver/intersection_graph.h>
#include <exsect/solver/result.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace exsect {

enum class SpaceNodeKind {
  joint,     // two arcs meet in a regular point of the curve
  cut,       // one arc, which goes on to infinity from here without another node
  end,       // one arc, in the apex of a cone of one nappe or on the rim of a box
  touch,     // an isolated common point
  crossing,  // three or more arcs
  singular,  // two arcs meet in an apex, or in a point where the surfaces touch or more arcs would without
             // boxes
};
/// "joint", ...
const char* name(SpaceNodeKind kind);

/// Closed boxes with one node in each.
struct SpaceNode {
  int id;
  SpaceNodeKind kind;
  int degree;  // the number of ends of arcs
  std::array<RationalInterval, 3> box;
  std::array<double, 3> approx;
  std::array<std::vector<std::string>, 2> bounds = {};  // of the boxes of both surfaces that it lies on
  /// Of a touch point: the sign of the second equation on the first surface around it, where that is proved.
  std::optional<int> around = {};
};

enum class SpaceCurveKind { line, circle, ellipse, parabola, hyperbola, general };
/// "line", ...
const char* name(SpaceCurveKind kind);

/// A piece of a curve between two nodes, with no node inside.
struct SpaceArc {
  int id;
  int curve;
  int from;
  int to;
  /// 1 if the surfaces cross; above 1 they touch along the arc, of this order; 0 if they are one surface and
  /// their boxes share the arc.
  int multiplicity;
  std::vector<std::array<double, 3>> polyline;
  double error_bound;  // of the distance between arc and polyline, both ways
  /// The signs of the second equation on the first surface, near the arc, to the left and to the right as it
  /// is seen from `from` to `to`, and from where the first equation is positive. Empty where they are not
  /// proved, and at multiplicity 0.
  std::optional<SideSigns> beside = {};
};

/// A named curve as a whole, as far as it is on one nappe of one-sided cones and in the boxes; `general` is a
/// connected part of an irreducible curve that is no line or conic over the field of its equations, or is not
/// known to be one. Its plane, centre and radius are given where they are rational.
struct SpaceCurve {
  int id;
  SpaceCurveKind kind;
  std::vector<int> arcs;
  bool is_closed;  // every node has two of its arcs
  int multiplicity;
  std::optional<Point> point = {};              // of a line; the centre of a circle, ellipse or hyperbola
  std::optional<Point> direction = {};          // of a line; the normal of the plane of others
  std::optional<Rational> radius_squared = {};  // of a circle
};

/// What is not known, and why.
struct OpenQuestion {
  std::string why;
  Reason reason = Reason::not_decided;
};

/// complete: every common point is on a curve, or a node of kind `touch`, or on the surface in common.
struct SurfaceIntersection {
  Status status;
  /// The surfaces are one, and their boxes and nappes share a part of it that has inner points; or they are
  /// polynomials with a common factor. Curves and points are then what they share besides.
  bool is_same = false;
  /// Of one surface: whether both equations are positive on the same side, 1, or not, -1; empty for two that
  /// have a factor in common.
  std::optional<int> normals = {};
  std::vector<SpaceNode> nodes = {};
  std::vector<SpaceArc> arcs = {};
  std::vector<SpaceCurve> curves = {};
  std::vector<OpenQuestion> incomplete = {};
  Work work = {};

  int count(SpaceNodeKind kind) const;
  int count(SpaceCurveKind kind) const;
};

/// Adds the nodes, arcs and curves of another answer, with further ids, and its open questions.
void append(SurfaceIntersection& to, SurfaceIntersection part);

}  // namespace exsect
