// Points on the arc of a tube, and whether points are. Internal to solver/.
#pragma once

#include "trace/tube.h"

namespace exsect {

/// An enclosure of the curve's point at tau, |tau| <= reach; work ends when its radius is about `enough`.
template <class Ball>
BallPoint<Ball> point_at(const Tube<Ball>& tube, double tau, double enough = 0);

/// An enclosure of the space position (in the scaled system) over an enclosure of parameters near the tube.
template <class Ball>
BallVector<Ball> space_point(const Tube<Ball>& tube, const BallPoint<Ball>& parameters);

/// The offset tau of a point's coordinate k, enclosed.
template <class Ball>
Ball offset(const Tube<Ball>& tube, const BallPoint<Ball>& point);

/// True only if the whole box lies in the tube's region: a curve point known to be in the box is then on its
/// arc.
template <class Ball>
bool contains(const Tube<Ball>& tube, const BallPoint<Ball>& box);

/// True only if no point of the box is on the tube's arc.
template <class Ball>
bool excludes(const Tube<Ball>& tube, const BallPoint<Ball>& box);

}  // namespace exsect
