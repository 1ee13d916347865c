// The eliminant E of the turning points of patches of any bidegrees, with weights or without, where it is
// affordable. Internal to solver/; docs/method-equations.md, sections 16.1 and 16.2.
#pragma once

#include <exsect/algebra/polynomial.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/parameter.h>

#include <optional>
#include <vector>

#include "eliminant/eliminant_proof.h"

namespace exsect {

/// The parameters along which the pair has an eliminant, those of lowest degree first: all four for bidegrees
/// (2,2), otherwise the one beside each parameter of degree 1 (16.17). The degrees are those of reduced().
std::vector<Parameter> eliminant_sweeps(const RationalPatch& x, const RationalPatch& y);

/// E != 0 of (16.9), (16.16) or (16.20) in the parameter: what turning_eliminant promises of its roots holds
/// for the solutions of X = λY inside the squares. Of degree at most 160 for bidegrees (2,2), 252 otherwise;
/// primitive with integer coefficients, positive leading coefficient. Empty where it is not defined (contact
/// along a curve) or would have over 2^19 bits. Requires one of eliminant_sweeps.
std::optional<Polynomial> weighted_eliminant(const RationalPatch& x, const RationalPatch& y, Parameter sweep);

/// The roots of E in (0,1), ascending: by 256 bits of its values or some 1000 to 2500 of its coefficients
/// where all roots in [0,1] are simple and these bits suffice; else by the exact coefficients. Empty where E
/// is not defined.
std::optional<std::vector<EliminantRoot>> weighted_turning_roots(const RationalPatch& x,
                                                                 const RationalPatch& y, Parameter sweep);

}  // namespace exsect
