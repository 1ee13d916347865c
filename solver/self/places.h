// What is known exactly of a patch against itself, and the curves traced from it. Internal to solver/.
#pragma once

#include <exsect/solver/result.h>

#include <functional>
#include <optional>
#include <vector>

#include "answer/graph_builder.h"
#include "self/boundary.h"
#include "self/chart_trace.h"
#include "self/cusp_arc.h"
#include "self/star.h"
#include "shape/fold_expansion.h"
#include "shape/special_cusps.h"
#include "trace/trace_graph.h"

namespace exsect {

/// A folded parameter line along which both tangent planes agree. Its pairs are f + t, f - t at the constant
/// c, 0 <= t <= min(f, 1 - f), of the patch (chart: first) or of the patch with exchanged parameters.
struct MultipleFold {
  FoldExpansion expansion;
  Chart chart;
  std::optional<int> side;         // c, if it is 0 or 1
  std::optional<std::size_t> end;  // the boundary point with the largest t; empty if that is 0
};

/// What is known exactly of a patch against itself.
struct ExactPlaces {
  InjectiveRectangles injective;
  SelfBoundary boundary;
  SpecialCusps cusps;
  std::vector<MultipleFold> folds;
  std::array<std::size_t, 4> coincident;  // coincident_parameters(x, x)
  /// Components of T that are known to vanish at a boundary point.
  std::function<std::array<bool, 4>(const CertifiedPoint&)> zero_tangent;
  /// KnownTangent::common_zero.
  std::function<std::optional<ParameterBox>(const ParameterBox&, std::size_t, std::size_t)> common_zero;
  std::vector<SelfStar> stars;
};

/// A patch against itself in one arithmetic: as a pair, and in both charts.
template <class Ball>
struct SelfSystem {
  SelfSystem(const BezierPatch& x, const Point& origin, long exponent)
      : pair(x, x, origin, exponent),
        charts{ChartSystem<Ball>(x, origin, exponent, Chart::first),
               ChartSystem<Ball>(x, origin, exponent, Chart::second)} {}
  const ChartSystem<Ball>& chart(Chart c) const { return chart_of(charts, c); }

  PairSystem<Ball> pair;
  Charts<Ball> charts;
};

/// A traced curve. `on`: sides on which it lies all along.
template <class Ball>
struct SelfCurve {
  AnalysedTrace<Ball> analysed;
  std::vector<Side> on;
};

/// `landmarks` are the boundary points (both orders), then two for each port of the stars, and for each trace
/// of `chart_traces` that ends at a gate: the port or gate, and exchanged. Every curve is traced in one of
/// its two orders, its pieces next to cuspidal points in the charts, the rest as a curve of pairs. Traces in
/// the charts that join two cuspidal points are curves on their own.
template <class Ball>
struct SelfCurves {
  struct Gate {
    std::size_t trace;
    bool exchanged;
  };

  struct PortOfStar {
    std::size_t star;
    std::size_t port;
    bool exchanged;
  };

  Landmarks<Ball> landmarks;
  std::size_t boundary_points = 0;
  std::vector<PortOfStar> ports;       // in the order of the landmarks
  std::vector<CuspArc<Ball>> cusps;    // with a curve in the domain
  std::vector<CuspArc<Ball>> leaving;  // those on sides, whose curve leaves it
  std::vector<ChartTrace<Ball>> chart_traces;
  std::vector<std::size_t> gates;  // indices of traces, in the order of the landmarks
  std::vector<SelfCurve<Ball>> curves;
  std::vector<int> isolated;  // boundary points at which no curve enters the domain, in one order
  std::vector<Incomplete> problems;
  long searched_boxes = 0;
  bool is_cut_short = false;  // the search ended undecided with less than its whole effort

  /// Empty for a boundary point or a port, and for the "landmark" -1 of a closed curve.
  std::optional<Gate> gate(int landmark) const {
    const std::size_t before = boundary_points + ports.size();
    if (landmark < static_cast<int>(before)) {
      return std::nullopt;
    }
    const std::size_t k = static_cast<std::size_t>(landmark) - before;
    return Gate{gates[k / 2], k % 2 == 1};
  }
  /// Null for all other landmarks.
  const PortOfStar* port(int landmark) const {
    const int k = landmark - static_cast<int>(boundary_points);
    return k < 0 || k >= static_cast<int>(ports.size()) ? nullptr : &ports[static_cast<std::size_t>(k)];
  }
};

}  // namespace exsect
