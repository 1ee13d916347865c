// Families of pairs in special position with their exact intersections. P is the plane patch (u, v, 0) or a
// reparametrisation of it, G[h] the graph patch (u, v, h(u,v)); a = u - 1/2, b = v - 1/2.
#pragma once

#include "support/exact_case.h"

namespace exsect::families {

/// The plane patch as second patch: (r, s, 0); ((3r - 1/2)/2, (3s - 1/2)/2, 0), larger than the unit square;
/// (r, s (1 + r), 0); ((r + r²)/2, (3s - s²)/2, 0); (r², s², 0), singular on two sides.
enum class Plane { square, larger, bilinear, quadratic, squares };
inline constexpr std::array<Plane, 5> all_planes = {Plane::square, Plane::larger, Plane::bilinear,
                                                    Plane::quadratic, Plane::squares};
inline constexpr std::array<Plane, 4> regular_planes = {Plane::square, Plane::larger, Plane::bilinear,
                                                        Plane::quadratic};

/// G[e - a² - b²] with P, e < 1/4. e > 0: a closed curve; e = 0: a touch point; e < 0: nothing.
ExactCase cap(const Rational& e, Plane plane);
/// G[a² - b²] with P: four arcs from a crossing to the corners.
ExactCase crossing(Plane plane);
/// G[(u² - 1/2) (v² - 1/3)] with P: two parameter lines that cross, irrational in all parameters.
ExactCase irrational_lines(Plane plane);
/// G[(2u² - 1) (12 b² - 1)] with the square P: one line in u, two in v.
ExactCase three_irrational_lines();
/// G[a² - b² - e] with P, 0 < e < 1/4: two open arcs.
ExactCase near_crossing(const Rational& e, Plane plane);
/// G[u² + v² - 1/2] with P: a quarter of a circle, which turns where it meets the sides u = 0 and v = 0.
ExactCase quarter_circle(Plane plane);
/// G[(u - c v - 1/4)²] with P, 0 <= c <= 3/4: one tangential arc.
ExactCase tangent_curve(const Rational& c, Plane plane);
/// G[a² - e²] with P, 0 < e < 1/2: two open arcs.
ExactCase near_sheets(const Rational& e, Plane plane);
/// G[a² + e] with P, e > 0: nothing.
ExactCase parted_sheets(const Rational& e, Plane plane);
/// G[a² b] with P: a tangential and a transversal line that cross.
ExactCase tangent_and_transversal(Plane plane);
/// G[(a-b)² - a² b] with P: a cusp of the curve.
ExactCase curve_cusp(Plane plane);
/// G[a² b²] with P: two lines along which the patches touch, and that cross.
ExactCase tangent_lines(Plane plane);
/// G[a (a - b²)] with P: two branches that touch.
ExactCase tangent_branches(Plane plane);
/// G[u (v - 1/3 - u/2)] with the square P: an arc along the common side u = r = 0, and another one that
/// leaves from its interior.
ExactCase side_and_arc();
/// G[u (v - u/2)] with the square P: the other arc leaves from the end of the side.
ExactCase side_and_arc_from_its_end();
/// G[a (v - 1/3 - u/2)] with P: an interior parameter line of both patches and an arc that crosses it.
ExactCase line_and_arc();

/// How the neighbour lies at the side u = 0 of the first example's patch x: y(r,s) = x(0, from + (to - from)
/// s) + (r - at) d, d = (0,0,1).
struct Neighbour {
  Rational from = 0;
  Rational to = 1;
  Rational at = 0;  // 0 or 1: y's side is on x; in between: an interior line of y
};
/// One arc on the patch boundary, v in [0,1] and [from,to]; the two have to have an interval in common.
ExactCase shared_side(const Neighbour& neighbour);
/// y(r,s) = x(-r, s) + k r² (0,0,1): x continued beyond u = 0, with (k != 0) or without a change of its
/// curvature: one tangential arc.
ExactCase smooth_neighbour(const Rational& k);
/// x(1/2, v) is y's side r = 0: y(r,s) = x(1/2, s) + r d.
ExactCase side_on_interior_line();
/// (u, v, u v) with (0, (s + s²)/2, r): one straight side at two parametrisations.
ExactCase side_at_two_speeds();
/// (u, v, u v) with (e (2s - 1), s, r), 0 < e <= 1: one arc that leaves the side u = 0 at its middle.
ExactCase turned_side(const Rational& e);

/// The first example's x and x over [1/3,4/3] x [-1/4,3/4]: they overlap.
ExactCase shifted_copy();
/// The first example's x twice.
ExactCase same_patch();
/// The first example's x and x + e (0,0,1), e != 0: nothing.
ExactCase lifted_copy(const Rational& e);
/// The first example's x and x + e (u + v - 1) (0,0,1), e != 0: one arc along the diagonal of both squares.
ExactCase tilted_copy(const Rational& e);
/// (u, v, 0) and (r + 1/2, s + 1/3, 0).
ExactCase coplanar_squares();
/// examples/touching-curve.json: tangential from (1/4,1) to (3/4,0).
ExactCase touching_curve(const BezierPatch& x, const BezierPatch& y);
/// ((2u-1)², v, 0) with (1/4, r, s - 1/2): two arcs over one segment of space.
ExactCase double_cover();
/// (u, u (2v-1), u²), whose side u = 0 is a point, with the plane (0, r - 1/2, s - 1/2): that point.
ExactCase collapsed_side();
/// The same patch with (r, 0, s): the arc v = 1/2 from that point.
ExactCase arc_from_collapsed_side();
/// (u'², u' v', v') with u' = 2u - 1, v' = 2v - 1 (Whitney's umbrella) and the plane (r, s - 1/2, 0): the
/// segment run through twice, through the pinch point.
ExactCase pinch_point();
/// The same umbrella with (2r - 1, s - 1/2, (2r - 1)/4), or (r, s - 1/2, r/4): a = 2u - 1, v' = a²/4, a cusp
/// in the (r,s) plane at the pinch point, inside the square or on its side r = 0.
ExactCase pinch_point_passed(bool on_side);

/// Quarters of a dome, (u c(v), 1 - u²) and turned ones: with u = r = 0 as common pole. A neighbour shares
/// the side v = 1, s = 0, with one tangent plane or not; the opposite quarter has the pole alone.
enum class PoleNeighbour { smooth, sharp, opposite };
ExactCase common_pole(PoleNeighbour which);
/// u (w, 1, w²), w = 2v - 1, with the planar r (4s - 2, 2, 1): two common rulings, v = s, irrational; or with
/// r (4s - 2, 1, 0): they touch along one.
ExactCase common_apex(bool touching);
/// Quarters of two tubes of one profile whose axes cross: a common point at corners of the profiles; the
/// curve through it is outside of the squares.
ExactCase crossing_tubes();
/// a = u - 1/2: (u, v (1 + a²), v² + a²/4) with the plane (s, 2r, 1/2): v and r, irrational, turn over u =
/// 1/2.
ExactCase symmetric_turns();
/// a = u - 1/2, b = v - 1/2: (u + v²/4, v + u²/4, h) and its image in the plane z = 0, h = a² + ab + b² -
/// 1/15: a closed curve, on which u turns with r and v with s, all of them irrational.
ExactCase mirror_images();

/// One member of each family, for tests/cases.
std::vector<ExactCase> specimens();

}  // namespace exsect::families
