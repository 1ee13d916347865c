// The curve that carries a rational parameter line, as equations in the parameters of the other patch.
// docs/method.md, section 3. Internal to solver/.
#pragma once

#include <exsect/algebra/triangular_point.h>
#include <exsect/geometry/rational_patch.h>

#include <array>
#include <optional>
#include <vector>

#include "line/line_parameter.h"
#include "line/moving_planes.h"

namespace exsect {

using ComponentsOfPatch = std::array<BivariatePolynomial, 4>;

/// X_1, ..., X_4.
ComponentsOfPatch components_of(const RationalPatch& patch);

/// Where the line's parameter is in [0,1] at a point of the patch.
struct LinePosition {
  LineParameter t;
  /// The carrier and the patch cross there: the tangent of the one is not in the tangent plane of the other,
  /// which the patch has.
  bool is_transversal;
};

/// a + b t, a and b in the parameters of the patch.
struct LinearInT {
  BivariatePolynomial a;
  BivariatePolynomial b;
};

class LineCarrier {
 public:
  /// The curve has no common factor and a degree of 1 to 3.
  LineCarrier(const HomogeneousCurve& curve, const ComponentsOfPatch& x);

  /// All vanish exactly at the points of the carrier, that of t = infinity included.
  const std::vector<BivariatePolynomial>& equations() const { return equations_; }

  /// The planes that hold the carrier: 2 of a straight line, 1 of another plane curve.
  const std::vector<MovingPlane>& fixed_planes() const { return fixed_; }

  /// Along a curve of common zeros of the equations, whether t is in [0,1] changes only where one of these
  /// vanishes, which do so at t = 0 and 1, and where a straight line turns back.
  std::vector<BivariatePolynomial> borders() const;

  /// Adds the positions with t in [0,1] of the point at a common zero of the equations; false where a base
  /// point of the patch hides them.
  bool add_positions(const TriangularPoint& p, std::vector<LinePosition>& to) const;
  /// The same as numbers: where quotient_at fails for one quotient, another one is tried.
  bool add_numbers(const TriangularPoint& p, std::vector<RealAlgebraic>& to) const;

 private:
  std::optional<RealAlgebraic> number_at(const TriangularPoint& p) const;
  std::vector<BivariatePolynomial> borders_of_segment() const;
  std::size_t changing_coordinate() const;
  BivariatePolynomial on_patch(const std::array<Rational, 4>& plane) const;
  LinearInT combined(int k) const;
  void add_plane_cubic();
  bool add_at_node(const TriangularPoint& p, std::vector<LinePosition>& to) const;
  bool add_on_straight_line(const TriangularPoint& p, std::vector<LinePosition>& to) const;

  HomogeneousCurve curve_;
  ComponentsOfPatch x_;
  int degree_;
  std::vector<MovingPlane> fixed_;
  std::vector<MovingPlane> moving_;
  std::vector<LinearInT> linear_;
  std::vector<BivariatePolynomial> equations_;
};

}  // namespace exsect
