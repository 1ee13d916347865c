// The point of an intersection curve nearest to a given point, in floating point: for measurements, proves
// nothing.
#pragma once

#include <optional>

#include "patch_pair.h"

namespace peers {

double distance(const Point& a, const Point& b);

/// |x(u,v) - y(r,s)|.
double residual(const PatchPair& pair, const std::array<double, 4>& parameters);

/// A solution of x(u,v) = y(r,s), locally nearest to `p` in space, by Newton's method from `start`; nothing
/// if it does not converge or leaves the parameter squares by more than 1e-6.
std::optional<Vertex> nearest_point(const PatchPair& pair, const Point& p,
                                    const std::array<double, 4>& start);

}  // namespace peers
