// Two patches of any kind, and F = x - y, as certificates speak of them.
#pragma once

#include <exsect/checker/map.h>
#include <exsect/geometry/rational_patch.h>

#include <array>

namespace exsect::cli {

using Patches = std::array<RationalPatch, 2>;
using ExactMap = checker::Map<Rational>;
using Place = checker::Vector4<Rational>;  // of four parameters, exactly
using Direction = checker::Vector4<Rational>;

/// The same map of the same parameters: of bidegree (2,2), if it can have this bidegree, otherwise reduced.
/// Throws NoCertificate for a patch with weights.
RationalPatch certified_form(const RationalPatch& patch);

/// The control points of the patch in its bidegree, and the coefficients of u^i v^j.
checker::Net<Rational> control_net(const RationalPatch& patch);
checker::Net<Rational> power_basis(const RationalPatch& patch);

/// F.
ExactMap equation_of(const Patches& patches);
/// F = 0 at the place, in [0,1]^4 or not.
bool is_solution(const Patches& patches, const Place& w);

}  // namespace exsect::cli
