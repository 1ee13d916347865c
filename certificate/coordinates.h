// Coordinates of the parameters in which F is a sum of multiples of some of them: factors along lines.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/checker/certificate.h>

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "certificate/events.h"
#include "certificate/search.h"

namespace exsect::cli {

using Scalar = std::map<checker::Power, Rational>;  // a polynomial in four variables

/// The exponents of w_i alone.
checker::Power variable(std::size_t i);

/// |f| at a place, beside the sum of its coefficients' absolute values: about 0 where f vanishes.
double near_value(const Scalar& f, const Parameters& w);

/// f as a polynomial in the parameters first and first + 1, and the reverse.
Scalar in_parameters(const BivariatePolynomial& f, std::size_t first);
BivariatePolynomial of_parameters(const Scalar& f, std::size_t first);

/// Coordinates z of the parameters: w = from(z) and z = to(w).
struct Coordinates {
  std::array<Scalar, 4> from;
  std::array<Scalar, 4> to;
};

/// F as a sum of multiples of z_1, z_2 and z_3^power, or of z_1 and z_2 alone for 0; nothing if it is none.
std::optional<checker::Factor> factor_in(const Coordinates& z, const ExactMap& equation, std::size_t power);

/// z_0 is the line's parameter, and w_i = line_i(z_0) + c_i z_3 + another coordinate: z_3 alone for m, where
/// c_m = 1, z_1 for i = first.
Coordinates along_line(const Line& line, std::size_t m, const Direction& c, std::size_t first);

/// Along a line on which the patches touch, in the same direction everywhere; `surface`: F vanishes on a
/// plane beside the line, which leaves [0,1]^4 there.
std::optional<checker::Factor> touching_factor(const Line& line, const ExactMap& equation, bool surface);

/// On curves along which w_i = c_i and w_j = c_j, of either patch one parameter: w_i - c_i, w_j - c_j and the
/// power of an irreducible polynomial in the others that is nearest to 0 at the places. Nothing if there is
/// none, or one of too high a degree.
std::optional<checker::Factor> factor_of_constants(const ExactMap& equation,
                                                   const std::array<std::size_t, 2>& constant, const Place& c,
                                                   const std::vector<Parameters>& near);

/// The same where the patches touch: w_j - c_j less a multiple of w_i - c_i, the polynomial, and the square
/// of w_i - c_i.
std::optional<checker::Factor> touching_factor_of_constants(const ExactMap& equation,
                                                            const std::array<std::size_t, 2>& constant,
                                                            const Place& c,
                                                            const std::vector<Parameters>& near);

}  // namespace exsect::cli
