// The curve that a torus has in common with another surface, as a graph over four patches that cover the
// torus. Internal to solver/; docs/method-equations.md, section 17.10.
#pragma once

#include <optional>
#include <vector>

#include "curve/surface_curve.h"
#include "lift/torus_chart.h"

namespace exsect {

/// An irreducible factor of the equation on the torus, in the parameters of the patch with halves 0.
struct TorusFactor {
  BivariatePolynomial factor;
  int multiplicity;
};

/// One of the four patches, and the curve on it in the region.
struct TorusPart {
  RationalPatch patch;
  std::vector<BivariatePolynomial> factors;  // those of the curve, in the parameters of this patch
  SurfaceCurve curve;
};

/// A node in `below` of one of the parts. Those on common sides of two parts are one node, of one of them.
struct TorusNode {
  std::size_t part;
  std::size_t below;  // in CurveGraph::nodes
  int degree;
  bool is_singular;
  std::vector<std::size_t> bounds;  // of the region, those with a name that it lies on
};

struct TorusArc {
  std::size_t part;
  std::size_t below;  // in CurveGraph::arcs
  std::size_t from;
  std::size_t to;
  std::size_t factor;
};

/// Invariant: as long as is_same is false, the common points in the region are those of the arcs, ends
/// included, and the nodes of degree 0.
struct TorusCurve {
  TorusFrame frame;
  TorusTurns turns;
  bool is_same = false;  // the torus lies on the other surface
  std::vector<TorusFactor> factors;
  std::vector<TorusPart> parts;
  std::vector<TorusNode> nodes;
  std::vector<TorusArc> arcs;
};

/// Empty where torus_frame() is. Of the surfaces the equations alone are looked at.
std::optional<TorusCurve> torus_curve(const ImplicitSurface& torus, const ImplicitSurface& other,
                                      const SurfaceRegion& region);

}  // namespace exsect
