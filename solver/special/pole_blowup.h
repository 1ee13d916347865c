// One of two patches near a pole that they have in common. Internal to solver/; docs/method-doubles.md,
// section 14.24.
#pragma once

#include <exsect/algebra/ball.h>
#include <exsect/geometry/rational_patch.h>

#include <map>
#include <utility>

#include "special/pole_directions.h"

namespace exsect {

/// What is known of a patch over an interval along its side.
struct SideCell {
  EnclosedVector d;
  DoubleBall square;  // of d
  DoubleBall bend;    // height times weight
};

/// Over a <= reach.
struct Blowup {
  Blowup(const RationalPatch& patch, const Point& p);

  /// Over the interval `dyadic(level, i)` along the side; computed once.
  const SideCell& cell(int level, long i);
  static RationalInterval dyadic(int level, long i);
  Rectangle over(const RationalInterval& at) const { return {{0, reach}, at}; }
  /// The weight is positive there too.
  bool reaches_to(int level, long i) const;

  BivariatePolynomial weight;
  PolynomialVector direction;  // D
  BivariatePolynomial height;  // G of n.D = a G, if there is a plane of all directions
  Rational reach;
  RationalInterval along = {0, 1};  // of the parameter along the side, which may be beyond its ends
  std::map<std::pair<int, long>, SideCell> cells;
};

/// (14.109), (14.110): no points a D(a,t)/w and b E(b,s)/W are equal.
bool are_apart(const SideCell& x, const SideCell& y);

}  // namespace exsect
