// Root isolation by Descartes' rule in the Bernstein basis (Vincent, Collins, Akritas): the default isolator.
#pragma once

#include <exsect/algebra/polynomial.h>

#include <vector>

namespace exsect {

/// Isolates one root: either lower == upper is the root itself (rational), or the open interval (lower,
/// upper) holds exactly one root, and the polynomial has opposite nonzero signs at its ends.
using IsolatingInterval = RationalInterval;

/// The real roots in the closed interval [a,b] of a squarefree polynomial, ascending, disjoint (ends may be
/// shared only if neither is a root). Works on integers throughout; the first bisection levels use a
/// certified fixed-point form. Throws std::domain_error for f = 0, std::invalid_argument for a > b and if f
/// has a multiple root in [a,b] (found, not assumed).
std::vector<IsolatingInterval> isolate_roots(const Polynomial& squarefree, const Rational& a,
                                             const Rational& b);

}  // namespace exsect
