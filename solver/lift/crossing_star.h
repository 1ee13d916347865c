// Where the curve of two polynomials in space is singular, or turns in no simple way, and the arcs that end
// there. Internal to solver/; docs/method-equations.md, section 17.15.
#pragma once

#include <exsect/algebra/triangular_point.h>

#include <array>
#include <optional>
#include <vector>

#include "lift/space_projection.h"

namespace exsect {

/// A common point that is no simple one over its u, or on a bound; the only one over its place in the shadow.
struct CrossingCentre {
  TriangularPoint below;  // u as its s and v as its r
  bool is_singular;       // the curve is
};

/// All real ones over u, with a bound of these signs (sign_below) or without. Empty if the frame does not
/// show what is over one of them: slope = 0, and the quadratic of the projection has no double zero in which
/// the curve is singular by (17.15a), or there are bounds.
std::optional<std::vector<CrossingCentre>> centres_over(const SpaceProjection& projection,
                                                        const RealAlgebraic& u,
                                                        const std::vector<BivariatePolynomial>& bounds = {});

/// The sign of a polynomial of r = u and s = v below the centre.
int sign_over(const BivariatePolynomial& f, const TriangularPoint& below);

/// A closed box of the point; of all common points over a rectangle of (u,v). Empty if the slope may be 0,
/// and so may c2 of the quadratic.
using CrossingBox = std::array<RationalInterval, 3>;
std::optional<CrossingBox> box_over(const SpaceProjection& projection, const RationalInterval& u,
                                    const RationalInterval& v);

/// Proves that f has no zero on the rectangle; false: not known.
bool has_no_zero_on(const BivariatePolynomial& f, const RationalInterval& u, const RationalInterval& v);

/// Invariant: the common points with u in the window and v in the strip are the centre and one arc from each
/// of the points over the ends of the window to the centre, along which u is monotone.
struct CrossingStar {
  RationalInterval window;
  RationalInterval strip;  // whose ends are no v of a point over the window
  CrossingBox box;         // of all
};

/// With a box whose longest side is at most `size` > 0. Requires that u of the centre is the only root of E
/// in the closed interval `free`, inside.
CrossingStar crossing_star(const SpaceProjection& projection, const CrossingCentre& centre,
                           const RationalInterval& free, const Rational& size);

}  // namespace exsect
