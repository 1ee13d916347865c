// Ordinary double points of the intersection with exact parameters: points in which the patches touch, and
// crossings of two branches. Internal to solver/; docs/method-doubles.md, sections 14.9, 14.16 and 14.18.
#pragma once

#include <vector>

#include "filter/local_bounds.h"
#include "filter/tube.h"

namespace exsect::filter {

/// A point on one of the arcs that end in a crossing, inside the domain: exactly one solution in the ball has
/// the value of ball.middle in `parameter`. From there to the centre all parameters are strictly monotone;
/// away from it `parameter` moves as from the end side = -+1/2 to the other one. The arc keeps within `chord`
/// (scaled space) of the chords from the centre through points near `approach` to one in the ball; the
/// vertices, x at `approach` and at ball.middle, are within `vertex_error` of these points; of polynomial
/// patches but for the rounding of the values of x.
template <class K>
struct PortOf {
  BallOf<K> ball;
  std::size_t parameter;
  double side;
  std::vector<Vec4> approach;
  double chord;
  double vertex_error;
};

/// A point in which arcs end, with a port for each, or a point alone.
template <class K>
struct CentreOf {
  std::array<RationalInterval, 4> box;  // around its parameters, within [0,1]
  Vec4 on;                              // 1/2 or -1/2 for the parameters at sides, exactly, 0 for the others
  Vec4 centre;                          // its parameters, centred; err by kUnit
  std::vector<PortOf<K>> ports;
};

/// Invariant: `at` is a solution, and singular. It is the only one in
/// the region |t| <= reach, |c_i| <= width[i], (r,s) - p = S t, (u,v) - p = c; or, if forms.crossing, four
/// arcs that end in it are all others, one with alpha > 0, one with alpha < 0, both with |beta| <= |alpha|/2,
/// and two with |alpha| <= |beta|/2. Each is a regular graph over the larger coordinate. Ports: for each of
/// these arcs one. If the point of a crossing is on sides, the region meets no others, no arc meets them
/// again in it, and ports are those of the arcs inside the domain; the others are outside.
template <class K>
struct DoublePointOf : CentreOf<K> {
  std::array<FieldNumber, 4> at;
  LocalFormsOf<K> forms;
  double reach;
  std::array<double, 2> width;
};

/// True if a parameter is 0 or 1.
template <class K>
bool is_on_side(const CentreOf<K>& point);

/// False only if the points are proved to be different.
template <class K>
bool may_be_same(const DoublePointOf<K>& point, const DoublePointOf<K>& other);

/// The double point where Newton's method for a common normal leads from `guess`, with ports as near to its
/// chords as `tolerance` says; empty if there is none of this kind, or something is not proved.
template <class K>
std::optional<DoublePointOf<K>> double_point_near(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                                  const PairOf<K>& pair, const Vec4& guess, double tolerance);

/// The coordinates t of all points of a box are within `error` of `t`, the determinant of S being above 2^-10
/// and the errors of its inverse below 2^-36.
struct LocalPlace {
  std::array<double, 2> t;
  std::array<double, 2> error;
  bool has_width;  // |c_i| <= width[i] for all of them
};
template <class K>
LocalPlace local_place(const DoublePointOf<K>& point, const Vec4& middle, const Vec4& half);

/// True only if all points of the box are in the region.
template <class K>
bool lies_in_region(const DoublePointOf<K>& point, const Vec4& middle, const Vec4& half);

}  // namespace exsect::filter
