// What two equations of surfaces have in common, and multiple factors of one. Internal to solver/.
#pragma once

#include <exsect/geometry/space_polynomial.h>

namespace exsect {

/// The greatest common divisor in Q[x,y,z], primitive. Requires polynomials other than 0.
SpacePolynomial common_factor(const SpacePolynomial& f, const SpacePolynomial& g);

/// f / g where g divides f; throws std::domain_error otherwise.
SpacePolynomial exact_quotient(const SpacePolynomial& f, const SpacePolynomial& g);

/// The product of the irreducible factors of f, each once, up to a constant one. Requires f != 0.
SpacePolynomial squarefree_part(const SpacePolynomial& f);

}  // namespace exsect
