// The curve that two surfaces given by any equations have in common. Internal to solver/;
// docs/method-equations.md, sections 17.15 to 17.17.
#pragma once

#include <exsect/geometry/surface_region.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "lift/space_projection.h"
#include "lift/space_zero.h"
#include "lift/surface_intersection.h"

namespace exsect {

/// Where u is extreme along the curve, where it is singular or meets a bound, or is cut off and goes on to
/// infinity.
struct CrossingNode {
  std::array<RationalInterval, 3> box;
  bool goes_on;
  bool is_singular;
  int degree;                            // the number of ends of arcs
  std::vector<std::size_t> bounds = {};  // of the region, that the point lies on
};

struct CrossingArc {
  std::size_t from;  // of smaller u
  std::size_t to;
  std::size_t factor;  // of the shadow, an irreducible one
  int multiplicity;    // 1 where the surfaces cross; above 1 they touch, or one of them is singular
  std::vector<std::array<double, 3>> points;
  double error_bound;
  SpaceZero begin;  // a cube of a point of the arc, near `from`
  int sense;        // 1 if the arc leaves it along grad f x grad g for the forms of its factor, -1 against it
};

/// Invariant: unless `open`, the arcs, ends included, and the nodes of degree 0 are all common
/// points of the surfaces, but for arcs that go on from nodes to infinity; along all of them the surfaces
/// cross.
struct CrossingCurve {
  bool is_same = false;  // the equations have a common factor: all its points, and the curve, are common
  std::optional<OpenQuestion> open = {};
  std::vector<CrossingNode> nodes = {};
  std::vector<CrossingArc> arcs = {};
  std::optional<SpaceProjection> projection = {};          // if there are arcs
  std::vector<BivariatePolynomial> factors = {};           // of its shadow
  std::vector<std::array<SpacePolynomial, 2>> forms = {};  // f = g = 0 cross along the arcs of each factor
};

/// Of F = 0 and G = 0, in either order, in the region. `tolerance` of an extent is how near polylines have to
/// be.
CrossingCurve crossing_curve(const SpacePolynomial& f, const SpacePolynomial& g, const SurfaceRegion& region,
                             const std::function<double(double)>& tolerance);

}  // namespace exsect
