// A Krawczyk tube: a certified piece of the intersection curve. Internal to solver/.
//
// Notation (docs/method.md, section 5): p centre, k axis, tau the offset of coordinate k, l(tau) = d tau +
// ... centre line (l_k = tau), C(tau) an approximate inverse of the three Jacobian columns other than k along
// it, rho the contraction.
#pragma once

#include <exsect/algebra/ball.h>

#include <array>
#include <cstddef>

#include "trace/centre_line.h"
#include "trace/pair_system.h"
#include "trace/preconditioned_newton.h"

namespace exsect {

/// Invariant (proved by certify_tube, with (5.2) and (5.3)): for every tau in [-reach, reach] there is
/// exactly one point w of the curve F = 0 with w_k = p_k + tau and |w_i - p_i - l_i(tau)| <= halfwidth_i for
/// i != k; the three columns other than k of the Jacobian are independent on the whole region, where the
/// matrix C DF has distance at most rho < 1 from the identity (row sum norm). So the region holds one regular
/// arc of the curve, a graph over tau, and nothing else.
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

}  // namespace exsect
