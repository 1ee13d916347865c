// Pieces of patches in coordinates of space in which they are as wide as they are long. Internal to
// solver/; docs/method-doubles.md, section 14.17.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/intersection_graph.h>

#include <array>
#include <optional>
#include <vector>

namespace exsect {

/// An affine map of space, q -> M (q - o), exact and invertible.
class Whitening {
 public:
  /// The control points of both pieces, with their weights positive, about their mean have nearly the unit
  /// matrix as their mean square, in all directions in which doubles tell that. Empty if they tell none, or a
  /// weight is not positive.
  static std::optional<Whitening> of(const RationalPatch& first, const RationalPatch& second);

  RationalPatch operator()(const RationalPatch& patch) const;
  /// A bound of lengths before by lengths behind the map.
  double stretch() const { return stretch_; }
  /// Points and bounds of a graph to space as it was.
  void restore(IntersectionGraph& graph) const;

 private:
  using Matrix = std::array<std::array<Rational, 3>, 3>;
  Whitening(const Matrix& map, const Matrix& inverse, const Point& origin);
  /// Returns a bound of what rounding moves the point.
  double restore(std::array<double, 3>& point) const;

  Matrix map_;
  Matrix inverse_;
  Point origin_;
  double stretch_;
};

}  // namespace exsect
