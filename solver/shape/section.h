// The intersection with a patch on a plane or a quadric, as a curve of the other patch's parameters. Internal
// to solver/; docs/method-doubles.md, section 14.13.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/tensor_bernstein.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/parameter.h>

#include <array>
#include <optional>
#include <vector>

namespace exsect {

/// rate = 0 at a solution where valid != 0 means w_i' = 0 there, on a regular arc of solutions along which f
/// has no singular point.
struct TurningCondition {
  BivariatePolynomial rate;
  BivariatePolynomial valid;
};

/// One patch lies on the plane or quadric F = 0; f, which is F(X) for the other one, X = (x,1) w,
/// with every factor once, is 0 at all solutions.
struct Section {
  std::size_t first;      // the global index of the other patch's first parameter, 0 or 2
  BivariatePolynomial f;  // not zero, in (r,s) for that patch's first and second parameter
  std::array<std::optional<TurningCondition>, 4> turning;
};

/// Of x with the surface of y, then of y with that of x, as far as they are planes or quadrics that do not
/// contain the other patch. The parameters of the patch on F are known where they are quotients of linear
/// forms of space, as on parallelograms, and cylinders, cones and spheres in their usual parameters.
std::vector<Section> sections(const RationalPatch& x, const RationalPatch& y);

/// The parameter is constant on a regular arc of solutions in the union of the closed boxes (14.34). False:
/// not known.
bool is_constant_in(const Section& section, std::size_t parameter, const std::vector<Rectangle>& boxes);

/// At the regular solution on the side, of which the section's other parameter is in the closed interval,
/// w_i' = 0. False: not known.
bool turns_on_side(const Section& section, std::size_t parameter, const Side& side,
                   const RationalInterval& other);

}  // namespace exsect
