// Complete search by subdivision for the self-intersection curve in one chart. Internal to solver/.
#pragma once

#include <functional>
#include <vector>

#include "answer/stop_request.h"
#include "self/known_places.h"
#include "self/tube.h"

namespace exsect {

/// Asked about an enclosed point of the curve: true if the connected curve through it leaves the domain or is
/// known by now (the callee may trace it), false if that could not be settled.
template <class Ball>
using ChartSeedHandler = std::function<bool(const BallPoint<Ball>&)>;

/// Looks for points of H = 0 in the `roots`, boxes that cover what is not known yet of the chart's part of
/// the domain, that is U +- t and V +- m t in [0,1]; at first {whole_chart}. A box is done if H cannot vanish
/// in it, or it is outside or in the known places. Any other box must be shown to be empty of points to be
/// found: without `known` that is all, so that an outcome without undecided boxes means that there are no
/// pairs. With `known`, a box is also done if a certified tube contains it whose curve is known, or if the
/// curve cannot have a tangent with c_0 U' + c_1 V' = 0 in it (`direction` c, in terms of u and v whichever
/// the chart: together the searches of both charts prove that there is no further closed curve if they are
/// along the same c).
template <class Ball>
SearchOutcome search_chart(const ChartSystem<Ball>& system, const KnownPlaces& places,
                           const std::vector<ChartBox>& roots, const std::array<double, 2>& direction,
                           const ChartSeedHandler<Ball>& known, long most_boxes, const StopRequest& stop);

/// A cuspidal point: H = 0 with w = 0. The tube has axis w; the point is the only one with w = 0 in it.
template <class Ball>
struct ChartCusp {
  ChartTube<Ball> tube;
  BallPoint<Ball> at;
};

template <class Ball>
struct CuspSearchOutcome {
  std::vector<ChartCusp<Ball>> cusps;  // |m| <= 1 up to a small margin, (U,V) in or near the unit square
  std::vector<ChartBox> undecided;
};

/// All cuspidal points of the chart outside the known places, each once.
template <class Ball>
CuspSearchOutcome<Ball> search_cusps(const ChartSystem<Ball>& system, const KnownPlaces& places,
                                     const StopRequest& stop);

}  // namespace exsect
