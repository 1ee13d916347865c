// The intersection near a pole, a side of a patch that is one point, which lies on the other patch. Internal
// to solver/; docs/method-doubles.md, section 14.24.
#pragma once

#include <exsect/algebra/tensor_bernstein.h>
#include <exsect/solver/intersection_graph.h>
#include <exsect/solver/parameter.h>

#include <array>
#include <optional>
#include <vector>

#include "curve/polynomial_vector.h"
#include "special/pole_on_patch.h"

namespace exsect {

/// The line x(.,t), on which r and s are (p + q a) / (1 + bend a), with the p and q of each; bend a > -1.
struct PoleRay {
  Rational t;
  std::array<std::array<Rational, 2>, 2> on_other;
  Rational bend;
};

/// From the pole to a = reach, with t and (r,s) in these intervals, which may reach beyond [0,1], and where
/// it is the only one; a is strictly monotone along it, and every other parameter that was asked for strictly
/// monotone or constant. It lies on the sides `on` of (a,t,r,s) as (u,v,r,s), and is inside of all others but
/// for the pole. At each a its point of space is within `bend` of pole + (a / reach) step.
struct PoleArc {
  RationalInterval along;
  std::array<RationalInterval, 2> on_other;
  std::vector<Side> on;
  Contact contact;
  std::array<double, 3> step;
  double bend;
  std::optional<PoleRay> ray = std::nullopt;  // if that is known
};

/// Makes (r,s) of an arc wider by a part of the wider direction, but not beyond `within`.
void add_room(PoleArc& arc, const std::array<RationalInterval, 2>& within);
/// Sets `step` and `bend` of an arc of points P + a D/w, with a and t in the rectangle.
void set_chord(PoleArc& arc, const PolynomialVector& direction, const BivariatePolynomial& weight,
               const Rectangle& on);

/// All arcs of x(a,t) = y(r,s) over 0 < a <= reach: each begins in the pole, and there is nothing else but
/// the pole with t free. `turning`: of (a,t,r,s) as (u,v,r,s). Empty if that is not proved. Requires 0 <
/// reach < 1.
std::optional<std::vector<PoleArc>> arcs_at_pole(const RationalPatch& x, const RationalPatch& y,
                                                 const PoleOnPatch& pole, const Rational& reach,
                                                 const std::vector<Parameter>& turning);

}  // namespace exsect
