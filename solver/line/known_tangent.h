// Of a point on a parameter line: whether it is rational, and which components of the tangent field are known
// to vanish there. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/certified_point.h>

#include <array>
#include <optional>

namespace exsect {

/// The point, if it is found to be rational: the simplest numbers in its box solve x = y. `point` is the only
/// solution in its box on a parameter line.
std::optional<std::array<Rational, 4>> rational_solution(const BezierPatch& x, const BezierPatch& y,
                                                         const CertifiedPoint& point);

/// The components of the tangent field that are known to vanish at a point: all that do, if it is known
/// exactly; otherwise on a line over which it is a multiple point of the fibre, and where two of its
/// parameters, on one patch, are found to be rational.
/// `point` is as above.
std::array<bool, 4> known_zero_tangent(const BezierPatch& x, const BezierPatch& y,
                                       const CertifiedPoint& point);

/// A box inside `where` that holds a point of the intersection at which components i and j of the tangent
/// field vanish; empty if none is found: one of its parameters must be a number much simpler than others in
/// `where`, such as one at which both patches are symmetric.
std::optional<ParameterBox> common_tangent_zero(const BezierPatch& x, const BezierPatch& y,
                                                const ParameterBox& where, std::size_t i, std::size_t j);

/// True if the point is known to be singular: all four components are known to vanish.
bool is_known_singular(const BezierPatch& x, const BezierPatch& y, const CertifiedPoint& point);

}  // namespace exsect
