// The graph of two patches from what they have in common in the square of one of them, by the inverse of the
// other one. Internal to solver/; docs/method-equations.md, section 17.19.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/surface_curve.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "answer/graph_builder.h"
#include "curve/region_outline.h"
#include "special/unit_map.h"

namespace exsect {

/// One of (u,v,r,s) on the curve: map(p) = numerator / denominator, the denominator positive there.
struct ParameterOnCurve {
  BivariatePolynomial numerator;
  BivariatePolynomial denominator;
  UnitMap map;
  BivariatePolynomial slope;  // (17.25)
};

/// Of the bound of the region at this position, if it is one.
struct SideBound {
  std::size_t position;
  Side side;
};

/// Where a part of a region comes to a pole of y and leaves it, along two sides of y that end in `pole`.
struct RimPole {
  Side pole;
  std::array<Side, 2> sides;  // of the arc that ends in the node, and of the one that begins there
};

/// The curve, or, if x lies on the surface of y, the region, whose rim `outline` is; curve.graph is its
/// graph.
struct InverseCurve {
  SurfaceCurve curve;
  std::array<ParameterOnCurve, 4> parameters;  // u and v of a curve alone
  std::optional<RegionOutline> outline;
  std::vector<SideBound> sides;  // of y
  std::vector<Side> poles;       // of a curve: sides of x that are one point of y, no parts of the section
  std::map<std::size_t, Side> in_poles;      // nodes that are poles of y, with its side; not of overlaps
  std::map<std::size_t, RimPole> rim_poles;  // nodes in which an overlap has such a side in its rim
  RationalPatch x;
  double extent;  // of the model
};

/// Polylines keep within `tolerance` (a length); turning points of curves with respect to `turning` are
/// nodes.
GraphBuilder inverse_graph(const InverseCurve& known, double tolerance,
                           const std::vector<Parameter>& turning);

}  // namespace exsect
