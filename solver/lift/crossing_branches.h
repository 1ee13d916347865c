// The irreducible parts of the curve of two polynomials in space, each with equations that cross along it.
// Internal to solver/; docs/method-equations.md, sections 17.15 and 17.16.
#pragma once

#include <exsect/algebra/polynomial.h>

#include <optional>
#include <vector>

#include "lift/space_projection.h"

namespace exsect {

/// Invariant: where the norm is not 0, the polynomials f and g cross along the branch, and u is a parameter
/// along it.
struct CrossingBranch {
  BivariatePolynomial shadow;  // irreducible
  int multiplicity;            // of the shadow in the resultant: 1 if the surfaces cross
  SpacePolynomial f;
  SpacePolynomial g;
  SpacePolynomial rate;  // of u along grad f x grad g
};

struct CrossingBranches {
  SpaceProjection projection;  // its shadow is the product of those of the branches
  std::vector<CrossingBranch> all;
  /// E(u) of (17.16), if there is one branch or several along which the surfaces cross; else the product of
  /// the norms of the rates, those of multiple branches squared.
  Polynomial norm;
};

/// Of F = G = 0. Empty if the frame does not tell branches apart, or both surfaces are singular along one.
/// Requires a shadow that is not constant.
std::optional<CrossingBranches> crossing_branches(const SpacePolynomial& f, const SpacePolynomial& g,
                                                  const SpaceProjection& projection);

}  // namespace exsect
