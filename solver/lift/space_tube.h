// Tubes around pieces of the curve of two polynomials in space, and the polylines in them. Internal to
// solver/; docs/method-equations.md, section 17.15.
#pragma once

#include <exsect/algebra/ball.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "lift/space_zero.h"

namespace exsect {

/// The points centre + s m + d with |s| <= reach, where m is 1 along the axis, |d_k| <= width[k], and d = 0
/// along the axis. Invariant: over each s there is exactly one common zero of the two polynomials in it;
/// these are an arc along which the coordinate of the axis has the sign `direction` along grad F x grad G.
class SpaceTube {
 public:
  /// Around the chord from one point to the other, beyond both by a part of its length. Empty if there is no
  /// proof (5.2), (5.3).
  static std::optional<SpaceTube> around(const SpacePolynomial& f, const SpacePolynomial& g,
                                         const Point& from, const Point& to);

  enum class Place { outside, inside, unknown };
  /// Of a cube.
  Place place_of(const SpaceZero& zero) const;
  /// The cube's centre is certainly beyond the other one's in the direction along grad F x grad G times
  /// `sense`: 1; certainly before it: -1; not known: 0. Of cubes inside.
  int order(const SpaceZero& first, const SpaceZero& second, int sense) const;
  /// A bound of the distance between the arc over the chord of two points inside and the chord, both ways.
  double distance_to_chord(const Point& from, const Point& to) const;

 private:
  SpaceTube() = default;

  static std::optional<SpaceTube> proved(const SpacePolynomial& f, const SpacePolynomial& g,
                                         const Point& from, const Point& to);

  std::array<DoubleBall, 3> offset(const Point& p, double radius) const;

  Point centre_;
  std::size_t axis_ = 0;
  std::array<double, 3> slope_{};
  double reach_ = 0;
  std::array<double, 3> width_{};
  int direction_ = 0;
};

}  // namespace exsect
