// Dixon's matrix of a patch of bidegree (2,2) and its determinant.
#pragma once

#include <exsect/geometry/integer_pair.h>
#include <exsect/geometry/space_polynomial.h>

#include <array>

namespace exsect {

/// m[0] + m[1] x + m[2] y + m[3] z.
using AffineEntry = std::array<Integer, 4>;
using DixonMatrix = std::array<std::array<AffineEntry, 8>, 8>;

/// With f(s,t) = c(s,t) - P, P = (x,y,z), the matrix of
///
///     det[f(s,t) f(a,t) f(a,b)] / ((s - a) (t - b))
///
/// in the monomials a^k b^l (k <= 3, l <= 1, row k + 4 l) and s^i t^j (i <= 1, j <= 3, column i + 2 j). Its
/// determinant vanishes for every P on the patch: (11.1), computed by (11.2).
DixonMatrix dixon_matrix(const IntegerNet& c);

/// The determinant, of degree at most 8; zero if and only if the patch has base points at infinity.
SpacePolynomial determinant(const DixonMatrix& m);

}  // namespace exsect
