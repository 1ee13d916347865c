// A graph over the square and a plane beyond it, in doubles: curves with closed formulas that end on sides of
// the graph alone.
#pragma once

#include "filter/boundary.h"
#include "filter/contact.h"
#include "filter/trace.h"
#include "filter/tube_derivatives.h"
#include "support/known_curves.h"

namespace exsect::testing {

/// z = 0 over [-1/4, 5/4]^2: r = (4 u + 1) / 6, s = (4 v + 1) / 6.
inline BezierPatch larger_plane() { return plane({q(-1, 4), q(-1, 4), 0}, {q(3, 2), 0, 0}, {0, q(3, 2), 0}); }

struct KnownCurve {
  BezierPatch x;
  BezierPatch y = larger_plane();
  filter::Pair pair;
  filter::Trees trees;
  long boxes = 0;
  std::vector<filter::BoundaryPoint> points;

  explicit KnownCurve(const HeightCoefficients& h) : KnownCurve(graph_patch(h)) {}
  explicit KnownCurve(BezierPatch graph)
      : x(std::move(graph)),
        pair(filter::make_pair(x, y).value()),
        trees{filter::PatchTree(pair.x), filter::PatchTree(pair.y)},
        points(filter::boundary_points(pair, {}, trees, boxes).value()) {}

  /// Centred, of the graph's (u,v).
  static filter::Vec4 centred(double u, double v) {
    return {u - 0.5, v - 0.5, (4 * u + 1) / 6 - 0.5, (4 * v + 1) / 6 - 0.5};
  }
  /// A certified tube over `axis`.
  filter::Tube tube(double u, double v, std::size_t axis, double reach) const {
    filter::Tube result;
    REQUIRE(filter::prepare(pair, centred(u, v), axis, result));
    const auto residual = filter::residual_bound(pair, result, reach);
    REQUIRE(filter::certify(pair, result, -reach, reach,
                            filter::halfwidths<filter::Biquadratic>(residual, 0x1p-30), residual));
    filter::bound_derivatives(pair, result);
    return result;
  }
  filter::Trace arc() const { return filter::trace_arc<filter::Biquadratic>(pair, points, 0).value(); }
};

}  // namespace exsect::testing
