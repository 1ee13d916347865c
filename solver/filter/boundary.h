// All boundary points of the intersection, by subdivision with certificates. Internal to solver/;
// docs/method-doubles.md, section 14.3.
#pragma once

#include <vector>

#include "filter/contact.h"
#include "filter/tube.h"

namespace exsect::filter {

/// Exactly one solution of x = y in the ball has `parameter` (centred) equal to `side`, which is 1/2 or -1/2,
/// as ball.middle has. It lies in the interior of the other three intervals, and the curve crosses the side.
/// Or, if `centre` is not -1, it is a port of that double point: see Port. Or, if on[j] is not 0 for several
/// j, it is a side point: see there; if it is `isolated` no curve ends in it.
template <class K>
struct BoundaryPointOf {
  BallOf<K> ball;
  std::size_t parameter;
  double side;
  int centre = -1;
  std::size_t port = 0;
  Vec4 on = {};
  bool isolated = false;
  int side_point = -1;  // its index in the contacts
};
using BoundaryPoint = BoundaryPointOf<Biquadratic>;

/// Every solution on a side but the contacts, which no other one is near, and the side points among these;
/// empty if that is not decided:
/// corners, tangents and sides on the other patch among other reasons. `boxes` counts the pairs looked at.
template <class K>
std::optional<std::vector<BoundaryPointOf<K>>> boundary_points(const PairOf<K>& pair,
                                                               const ContactsOf<K>& contacts,
                                                               TreesOf<K>& trees, long& boxes);

/// Adds to the contacts the sides of one patch that lie on the other one along a straight line of its
/// parameters, of patches that are not biquadratic along a side of it, if `boundary_points` fails for that
/// reason. False if there are none that it does not know.
template <class K>
bool add_side_paths(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair, TreesOf<K>& trees,
                    ContactsOf<K>& contacts);

}  // namespace exsect::filter
