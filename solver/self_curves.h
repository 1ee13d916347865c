// All curves where a patch meets itself, traced from boundary points, cuspidal points and searches, with the
// proof that none is missing. Internal to solver/.
#pragma once

#include <exsect/solver/result.h>

#include <optional>
#include <vector>

#include "graph_builder.h"
#include "self_boundary.h"
#include "self_cusp_arc.h"
#include "special_cusps.h"

namespace exsect {

/// What is known exactly of a patch against itself.
struct ExactPlaces {
  SelfBoundary boundary;
  SpecialCusps cusps;
  std::array<std::size_t, 4> coincident;  // coincident_parameters(x, x)
};

/// A patch against itself in one arithmetic: as a pair, and in both charts.
template <class Ball>
struct SelfSystem {
  SelfSystem(const BezierPatch& x, const Point& origin, long exponent)
      : pair(x, x, origin, exponent),
        charts{ChartSystem<Ball>(x, origin, exponent, Chart::first),
               ChartSystem<Ball>(x, origin, exponent, Chart::second)} {}
  const ChartSystem<Ball>& chart(Chart c) const { return charts[c == Chart::first ? 0 : 1]; }

  PairSystem<Ball> pair;
  std::array<ChartSystem<Ball>, 2> charts;
};

/// A traced curve. `along`: the side v (or u) = value on which both its preimages lie, as a side of (u1,v1).
template <class Ball>
struct SelfCurve {
  AnalysedTrace<Ball> analysed;
  std::optional<Side> along;
};

/// `landmarks` are the boundary points (both orders), then two gates for each cuspidal point: the one with t
/// > 0, and exchanged. Every curve is traced in one of its two orders.
template <class Ball>
struct SelfCurves {
  Landmarks<Ball> landmarks;
  std::vector<CuspArc<Ball>> cusps;
  std::vector<SelfCurve<Ball>> curves;
  std::vector<int> isolated;  // boundary points at which no curve enters the domain, in one order
  std::vector<Incomplete> problems;
  long searched_boxes = 0;
};

/// If no problem is reported, the curves, their pieces next to the cuspidal points and the isolated points
/// are all pairs u1,v1 != u2,v2 with x(u1,v1) = x(u2,v2) in the squares, and no other curve ends in a
/// cuspidal point. `width`: of the boxes around exact points. Precondition: exact.boundary.problems is empty.
template <class Ball>
SelfCurves<Ball> trace_self_curves(const SelfSystem<Ball>& system, const ExactPlaces& exact,
                                   const Rational& width, const StopRequest& stop);

/// True if a short search proves that the patch does not meet itself and has no cuspidal point.
bool is_quickly_injective(const SelfSystem<DoubleBall>& system, const StopRequest& stop);

}  // namespace exsect
