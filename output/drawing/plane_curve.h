// Curves in the unit square for pictures, in doubles: nothing here decides anything.
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace exsect::cli {

/// A point of the unit square: to the right, upwards.
using PlanePoint = std::array<double, 2>;
using PlanePolyline = std::vector<PlanePoint>;

/// Vertices of the polyline, first and last included, such that no dropped vertex is further than `tolerance`
/// from the chord that replaces it (Douglas and Peucker).
PlanePolyline simplified(const PlanePolyline& polyline, double tolerance);

/// The zero set of f in the unit square, seen on a grid of n by n cells: polylines whose vertices are zeros
/// of f on the grid's edges. A loop repeats its first vertex. Curves where f does not change sign are not
/// seen.
std::vector<PlanePolyline> zero_set(const std::function<double(PlanePoint)>& f, int n);

}  // namespace exsect::cli
