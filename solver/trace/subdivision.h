// Complete search by subdivision: every intersection point in a region lies on a known curve, or starts a new
// one, or in a reported undecided box. Internal to solver/.
#pragma once

#include <functional>
#include <vector>

#include "trace/breadth_first.h"
#include "trace/tracer.h"

namespace exsect {

/// What the search asks about a curve point it found: true if it is outside the domain or on a curve known by
/// now (the callee may trace a new one), false if that could not be settled.
template <class Ball>
using SeedHandler = std::function<bool(const BallPoint<Ball>&)>;

/// True only if the search may leave the region out: its solutions are known in another way.
using SettledRegion = std::function<bool(const SearchRegion&)>;

/// Precondition: all intersection points on the sides of the two squares are known and their curves traced.
/// Looks for the points of the intersection in `region` where c.T = 0, c = (direction[0], direction[1], 0, 0)
/// and T the tangent field: every closed curve and every singular point of the intersection has one (a closed
/// curve where c_u u + c_v v is largest; if `region` is not the whole domain, only those curves that have
/// such a point in it). A box is done if hulls are separated, if c.T cannot vanish, if a certified tube
/// contains it of whose arc one of three points is `known`, or if `settled`, unless empty, says so.
template <class Ball>
SearchOutcome search_closed_curves(const PairSystem<Ball>& system, const SearchRegion& region,
                                   const std::array<double, 2>& direction, const SeedHandler<Ball>& known,
                                   const SettledRegion& settled, const StopRequest& stop);

}  // namespace exsect
