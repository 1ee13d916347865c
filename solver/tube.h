// Krawczyk tubes: certified pieces of the intersection curve. Internal to solver/.
//
// Notation (docs/method.md, section 5): p centre, k axis, tau the offset of coordinate k, l(tau) = d tau +
// ... centre line (l_k = tau), C(tau) an approximate inverse of the three Jacobian columns other than k along
// it, rho the contraction.
#pragma once

#include <exsect/algebra/ball.h>

#include <array>
#include <cmath>
#include <optional>

#include "centre_line.h"
#include "pair_system.h"
#include "preconditioned_newton.h"

namespace exsect {

/// Invariant (proved by certify_tube): for every tau in [-reach, reach] there is exactly one point w of the
/// curve F = 0 with w_k = p_k + tau and |w_i - p_i - l_i(tau)| <= halfwidth_i for i != k; the three columns
/// other than k of the Jacobian are independent on the whole region, where the matrix C DF has distance at
/// most rho < 1 from the identity (row sum norm). So the region holds one regular arc of the curve, a graph
/// over tau, and nothing else.
template <class Ball>
struct Tube {
  BallPoint<Ball> centre;  // radius 0
  std::size_t axis;
  double reach;
  double scale;                 // a power of two, at least the reach
  CentreLine<Ball> line;        // l as a polynomial in sigma = tau / scale
  std::array<double, 4> slope;  // d in doubles
  /// One for each coordinate, 0 for k: where two branches are near each other, the coordinate that tells
  /// them apart needs a narrow tube, the others a wide one.
  std::array<double, 4> halfwidth;
  double contraction;
  /// By columns j other than k: bounds of |C D_j - 1| on the region.
  std::array<std::array<double, 3>, 4> deviation;
  /// w'(tau) lies in slope +- slope_error, w''(tau) in second +- second_error, on all of the tube.
  std::array<double, 4> slope_error;
  std::array<double, 4> second;
  std::array<double, 4> second_error;
  /// Bounds of |w' - l'| and |w'' - l''| on all of the tube.
  std::array<double, 4> slope_remainder;
  std::array<double, 4> second_remainder;
  /// Sign of the tangent field's component T_k, the same on all of the region: +1 if T points to larger tau.
  int orientation;
  /// M x and -M y as Taylor nets at p, and x itself for positions in space. The rows of M are a normal vector
  /// of one patch and two axes of space: where the patches are nearly tangent, the equation of the normal
  /// direction is the one with large factors, and it is free of what the other two contain.
  std::array<TaylorNet<Ball>, 2> nets;
  TaylorNet<Ball> space;
  /// C M^-1, the Taylor polynomial in sigma of the inverse of M times the columns along the line, radius 0.
  std::array<BallMatrix<Ball>, kLineDegree<Ball> + 1> preconditioner;
  /// Bound of the Euclidean norm of the second derivative of the space curve with respect to tau.
  double space_second_derivative;
};

/// The coordinate with the largest component, about.
template <class Ball>
std::size_t steepest_axis(const BallPoint<Ball>& tangent) {
  std::size_t axis = 0;
  for (std::size_t j = 1; j < 4; ++j) {
    if (std::fabs(tangent[j].approximation()) > std::fabs(tangent[axis].approximation())) {
      axis = j;
    }
  }
  return axis;
}

/// The tube around `centre` (its midpoints are used) over tau in [-reach, reach], half widths at least
/// `least_halfwidth`; empty if it cannot be proved with these numbers.
template <class Ball>
std::optional<Tube<Ball>> certify_tube(const PairSystem<Ball>& system, const BallPoint<Ball>& centre,
                                       std::size_t axis, double reach, double least_halfwidth);

/// The largest of the reaches most, most / 2, most / 4, ..., at least about `least`, for which the tube
/// around `centre` is proved with the half widths given, if longer ones are harder to prove; 0 if there is
/// none.
template <class Ball>
double largest_reach(const PairSystem<Ball>& system, const BallPoint<Ball>& centre, std::size_t axis,
                     double least, double most, double least_halfwidth, double worst_contraction);

/// Approximate Newton correction of the coordinates other than `axis` towards F = 0 (an estimate, not a
/// proof); empty if the columns are numerically dependent.
template <class Ball>
std::optional<BallPoint<Ball>> newton_corrected(const PairSystem<Ball>& system, const BallPoint<Ball>& start,
                                                std::size_t axis, int steps);

/// The values of a function on an interval are within `error` of `middle`.
struct ValueRange {
  double middle;
  double error;
  bool has_sign() const { return middle > error || -middle > error; }
};
/// w_i'(tau) and w_i''(tau) for all tau between two offsets, in either order.
template <class Ball>
ValueRange slope_between(const Tube<Ball>& tube, std::size_t i, double from, double to);
template <class Ball>
ValueRange second_between(const Tube<Ball>& tube, std::size_t i, double from, double to);

/// An enclosure of the curve's point at tau, |tau| <= reach; work ends when its radius is about `enough`.
template <class Ball>
BallPoint<Ball> point_at(const Tube<Ball>& tube, double tau, double enough = 0);
/// An enclosure of the space position (in the scaled system) over an enclosure of parameters near the tube.
template <class Ball>
BallVector<Ball> space_point(const Tube<Ball>& tube, const BallPoint<Ball>& parameters);
/// The offset tau of a point's coordinate k, enclosed.
template <class Ball>
Ball offset(const Tube<Ball>& tube, const BallPoint<Ball>& point);

/// True only if the whole box lies in the tube's region: a curve point known to be in the box is then on its
/// arc.
template <class Ball>
bool contains(const Tube<Ball>& tube, const BallPoint<Ball>& box);
/// True only if no point of the box is on the tube's arc.
template <class Ball>
bool excludes(const Tube<Ball>& tube, const BallPoint<Ball>& box);

}  // namespace exsect
