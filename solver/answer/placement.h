// Models that are far from the origin for their size, or of a size that doubles hardly hold, solved about the
// origin. Internal to solver/; docs/method.md, section 8.
#pragma once

#include <exsect/geometry/implicit_surface.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/intersection_graph.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace exsect {

/// The largest extent of the common box of the control points.
Rational model_extent(const BezierPatch& x, const BezierPatch& y);
/// That of the box of these points, at least one.
Rational model_extent(std::span<const Point> points);

/// The control points that are points of space, those with positive weights.
std::vector<Point> affine_points(const RationalPatch& patch);

/// The exact map q -> origin + 2^exponent q from a model about the origin, of extent in [1/2, 1), to the
/// model that is given. The same rational points of the parameter squares solve both.
class Placement {
 public:
  /// Empty where doubles hold the model well as it is: neither far from the origin for its extent, nor large
  /// or small.
  static std::optional<Placement> of(const BezierPatch& x, const BezierPatch& y);
  /// The same for a model with these control points, at least one.
  static std::optional<Placement> of(std::span<const Point> points);

  /// A patch of the given model, moved and scaled.
  BezierPatch placed(const BezierPatch& patch) const;
  RationalPatch placed(const RationalPatch& patch) const;
  /// The same for a surface given by its equation.
  ImplicitSurface placed(const ImplicitSurface& surface) const;
  Point placed(const Point& point) const;

  /// What rounding the points that are put back leaves of a tolerance, relative to the extent; at least half
  /// of it.
  double left_of(double tolerance) const;

  /// Puts points and error bounds of a solution into the given model. A coordinate is one of the doubles next
  /// to the true one, infinite beyond their range; bounds count the rounding, and are infinite for an arc
  /// with such a coordinate.
  void restore(IntersectionGraph& graph) const;
  /// The same for one point; returns a bound of the distance that rounding moves it.
  double restore(std::array<double, 3>& point) const;
  /// A bound of distances, and what rounding moves the points.
  double restored(double bound, double moved) const;
  /// Exactly.
  Point restored(const Point& point) const;
  const Rational& scale() const { return scale_; }

 private:
  Placement(Point origin, long exponent);
  void restore(Arc& arc) const;

  Point origin_;
  long exponent_;
  Rational scale_;              // 2^exponent
  std::array<double, 3> high_;  // of the origin, in doubles
  std::array<double, 3> low_;   // what `high_` lacks
};

}  // namespace exsect
