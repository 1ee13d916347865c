// Where the lines u = const touch a plane curve f(u,v) = 0: Res_v(f, f_v) for large integer coefficients.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

namespace exsect {

/// Res_v(f, f_v) for the primitive integer multiple of f, as a polynomial in u; u stands in the place of r
/// and v in that of s. By values modulo primes, as many as a proved bound of the height asks for. 1 if f does
/// not contain v; zero if f has a multiple factor that contains v. Throws std::domain_error for f = 0.
Polynomial turning_resultant(const BivariatePolynomial& f);

}  // namespace exsect
