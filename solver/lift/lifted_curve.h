// The curve that two surfaces have in common, as a graph over its shadow in the plane. Internal to solver/;
// docs/method-equations.md, section 17.5.
#pragma once

#include <exsect/solver/curve_graph.h>

#include <vector>

#include "lift/surface_chart.h"

namespace exsect {

/// An irreducible factor of common * norm, with its exponents in both.
struct ShadowFactor {
  BivariatePolynomial factor;
  int in_common;
  int in_norm;
};

/// The point over a node of the shadow with the sign of y.
struct LiftedNode {
  std::size_t below;  // in CurveGraph::nodes
  int sheet;
  int degree;
  bool is_singular;                      // of degree 2, and not proved to be regular
  bool goes_on;                          // cut off at u = 0 or u = 1, where an arc goes on to infinity
  std::vector<std::size_t> bounds = {};  // of the region, those with a name that the point lies on
};

/// The points over an arc of the shadow with one sign of y inside.
struct LiftedArc {
  std::size_t below;  // in CurveGraph::arcs
  int sheet;
  std::size_t from;
  std::size_t to;
  std::size_t factor;
  int multiplicity;  // order of contact of the surfaces along it, 1 where they cross
};

/// Invariant: as long as is_same is false, the common points of the surfaces in the region with u in [0,1]
/// are those of the arcs, ends included, and the nodes of degree 0. Every arc of the shadow is monotone in v.
struct LiftedCurve {
  SurfaceChart chart;
  Shadow shadow;
  bool is_same = false;  // the whole surface of the chart lies on the other one
  std::vector<ShadowFactor> factors;
  CurveGraph below;
  std::vector<LiftedNode> nodes;
  std::vector<LiftedArc> arcs;
};

/// Empty where chart_of() is. Of the surfaces the equations alone are looked at.
std::optional<LiftedCurve> lifted_curve(const ImplicitSurface& surface, const ImplicitSurface& other,
                                        const SurfaceRegion& region);

/// On this chart of the surface: without nodes and arcs yet, and with them.
LiftedCurve unlifted_curve(SurfaceChart chart, const ImplicitSurface& other);
void lift(LiftedCurve& curve, const ImplicitSurface& surface, const ImplicitSurface& other,
          const SurfaceRegion& region);

/// The exact sign of a + b y at the point over p with this sign of y.
int sign_on_sheet(const SheetFunction& f, const SurfaceChart& chart, const TriangularPoint& p, int sheet);

}  // namespace exsect
