// Singular pairs of a self-intersection over an algebraic value of a parameter, exactly. Internal to solver/;
// docs/method.md, section 7.6.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/certified_point.h>

#include <vector>

#include "self/turning.h"

namespace exsect {

/// A pair of different points of the square as (u1,v1,u2,v2), and the components of T that vanish there.
struct TurningPair {
  ExactParameters pair;
  std::array<bool, 4> zero;
};

/// The pairs over v1 = value at which the curve turns with respect to v1, or is singular, but for those over
/// a (u2,v1) with infinitely many, where Q has roots of multiplicity above 2, and where
/// its coefficients have more than 4000 bits.
std::vector<TurningPair> turning_pairs_over(const BezierPatch& x, const SelfProjection& projection,
                                            const RealAlgebraic& value);

/// Those at which both tangent planes agree; none where Q vanishes all over v1 = value.
std::vector<ExactParameters> singular_pairs_over(const BezierPatch& x, const SelfProjection& projection,
                                                 const RealAlgebraic& value);

/// Whether parameter j of the point is this number.
bool has_value(const ExactParameters& point, std::size_t j, const RealAlgebraic& value);

}  // namespace exsect
