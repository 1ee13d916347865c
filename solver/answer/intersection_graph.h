// The intersection graph: nodes, arcs, components.
#pragma once

#include <exsect/solver/parameter.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace exsect {

enum class NodeKind { boundary, turning, corner, touch, crossing, cusp, end_of_overlap };

/// Of a point at which the intersection is singular: touch if no arc ends there, cusp inside of the squares
/// with two, else crossing. On a side there may be further branches outside.
constexpr NodeKind singular_kind(std::size_t degree, bool inside) {
  if (degree == 0) return NodeKind::touch;
  return inside && degree == 2 ? NodeKind::cusp : NodeKind::crossing;
}

/// A certified point of the intersection. Its closed box holds exactly one point with the stated properties.
/// If there are `free` parameters, each of them runs through its whole interval of the box, independently of
/// the others, while the remaining ones and the point of space stay fixed: the node stands for all of these
/// solutions (a collapsed side, a patch that is a curve or a point), and `on` names the sides that all of
/// them lie on.
struct Node {
  int id;
  std::vector<NodeKind> kinds;
  std::vector<Side> on;        // sides of the parameter squares it lies on, exactly
  std::vector<Parameter> wrt;  // parameters with respect to which it is a turning point
  ParameterBox box;
  std::array<double, 4> approx;  // (u,v,r,s), inside the box up to rounding
  std::array<double, 3> point;   // approximate point of space
  std::vector<Parameter> free = {};
  /// Of an isolated point: the side, -1 or 1 as in SideSigns, on which the first patch lies around it, where
  /// that is proved.
  std::optional<int> around = {};
  /// The bounds of the surface's box (geometry/surface_box.h) it lies on, exactly: "height=from".
  std::vector<std::string> bounds = {};
};

/// Parameters (u,v,r,s) and the point of space.
struct PolylineVertex {
  std::array<double, 4> parameters;
  std::array<double, 3> point;
};

enum class ArcPlace { interior, patch_boundary };
enum class Contact { transversal, tangential };

/// On which side of the other surface the first patch lies to the left and to the right of an arc, near it:
/// seen from `from` to `to` in the square, u to the right and v upwards. 1 is the side that y_r x y_s points
/// to, for a surface given by its equation that of a positive equation, and -1 the other one. Equal if they
/// touch without crossing. Seen in the same way, the second patch lies to the left of a transversal arc on
/// the side -left of the first one. docs/method.md, section 8.4.
struct SideSigns {
  int left;
  int right;

  friend bool operator==(const SideSigns&, const SideSigns&) = default;
};

/// A piece of the intersection curve between two nodes, with no node inside. Every point of the true arc is
/// within `error_bound` (in space) of the polyline and every point of the polyline within it of the true arc.
/// `free` parameters run through [0,1] at every point of the arc, independently of the others (a patch that
/// is a curve); the polyline shows them at 1/2.
struct Arc {
  int id;
  int component;
  int from;  // node ids
  int to;
  ArcPlace place;
  Contact contact;
  std::vector<PolylineVertex> polyline;  // from `from` to `to`
  double error_bound;
  std::vector<Parameter> free = {};
  std::optional<SideSigns> beside = {};  // where it is proved; not of one patch with itself
};

/// open: a simple path; closed: a simple loop; branched: anything with a node of degree above two.
enum class ComponentShape { open, closed, branched };

struct Component {
  int id;
  ComponentShape shape;
  std::vector<int> arcs;  // open and closed: in order along the curve
};

/// A region where the two patches lie on one surface: its closed chains of boundary arcs on both squares. The
/// arcs belong to no component (`component` is -1) and their ids count through the chains of this overlap.
/// `normals`: 1 if x_u x x_v and y_r x y_s point to the same side, -1 if to opposite ones, at every node of
/// the chains in which that is decided; empty if it is in none, if they differ, and with an equation.
struct Overlap {
  int id;
  std::vector<std::vector<Arc>> chains;
  std::optional<int> normals = {};
};

/// Invariant: every arc end names a node; exchanging the patches gives the same graph up to renaming.
struct IntersectionGraph {
  std::vector<Node> nodes;
  std::vector<Arc> arcs;
  std::vector<Component> components;
  std::vector<int> isolated_points;  // node ids
  std::vector<Overlap> overlaps;

  int count(ComponentShape shape) const;
  /// Nodes that are turning points with respect to p, over all components.
  int turning_points(Parameter p) const;
  int boundary_points() const;
};

const char* name(NodeKind kind);
const char* name(ArcPlace place);
const char* name(Contact contact);
const char* name(ComponentShape shape);

}  // namespace exsect
