// Implicit surfaces of revolution about the z axis from implicit profiles f(r,z) = 0.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/space_polynomial.h>

namespace exsect {

/// f(r,z) = even(r^2, z) + r odd(r^2, z). Polynomials in (r,z) have r as their first variable and z as their
/// second; those in (R,z), R = r^2 = x^2 + y^2, have R as their first.
struct ParityParts {
  BivariatePolynomial even;
  BivariatePolynomial odd;
};
ParityParts parity_parts(const BivariatePolynomial& f);

/// (12.15): f(sqrt R, z) f(-sqrt R, z) = even^2 - R odd^2, in (R,z).
BivariatePolynomial revolved_by_product(const BivariatePolynomial& f);
/// (12.14): Res_r(f, r^2 - R), in (R,z). Equal to the product, sign included; another route.
BivariatePolynomial revolved_by_elimination(const BivariatePolynomial& f);
/// (12.17): g with g(r^2, z) = f(r,z). Throws std::invalid_argument if f has odd powers of r.
BivariatePolynomial revolved_by_substitution(const BivariatePolynomial& f);

/// g(x^2 + y^2, z).
SpacePolynomial surface_of_revolution(const BivariatePolynomial& g);

/// g(x^2 + y^2, z) on the patch (x,y,z)(u,v), as a polynomial in (u,v); g is not expanded.
BivariatePolynomial compose_revolution(const BivariatePolynomial& g, const BezierPatch& patch);

/// On g = 0, R > 0: the sheet f(sqrt R, z) = 0, or the mirrored one f(-sqrt R, z) = 0 that elimination and
/// product add, or both.
enum class Sheet { own, mirrored, both };
const char* name(Sheet sheet);

/// From the sign of even odd at a point with g = 0 and R > 0: f(sqrt R) = 0 there is even = -sqrt(R) odd.
constexpr Sheet sheet_of_sign(int sign_of_even_times_odd) {
  return sign_of_even_times_odd < 0 ? Sheet::own : sign_of_even_times_odd > 0 ? Sheet::mirrored : Sheet::both;
}

}  // namespace exsect
