// Charts of tori, cylinders and cones by an angle about the axis and one along the profile, and the equation
// of another round surface on them, in balls. Internal to solver/; docs/method-equations.md, section 17.21.
#pragma once

#include <exsect/algebra/ball.h>
#include <exsect/algebra/rounding_bounds.h>
#include <exsect/geometry/implicit_surface.h>

#include <array>
#include <cmath>
#include <optional>

#include "filter/round_formula.h"

namespace exsect {

/// An angle, that of the direction (a,b), of a length within 2^-50 of 1, or the number a.
using RoundCoordinate = std::array<double, 2>;

/// See `turned`; of several at once, each by at most 1/4 unless `is_far`.
template <class X>
std::array<X, 2> turned_by(const std::array<X, 2>& v, const X& x, bool is_far) {
  // The terms that are left out are below 2^-52, and sums and products err by 2^-51.
  const X y = x * x;
  X c{}, s{};
  if (is_far) {
    c = y * (1. / 479001600 - y * (1. / 87178291200 - y * (1. / 20922789888000)));
    s = y * (1. / 6227020800 - y * (1. / 1307674368000 - y * (1. / 355687428096000)));
  }
  c = 1. - y * (1. / 2 - y * (1. / 24 - y * (1. / 720 - y * (1. / 40320 - y * (1. / 3628800 - c)))));
  s = x - x * (y * (1. / 6 - y * (1. / 120 - y * (1. / 5040 - y * (1. / 362880 - y * (1. / 39916800 - s))))));
  const X a = v[0] * c - v[1] * s, b = v[0] * s + v[1] * c;
  const X scale = 1.5 - 0.5 * (a * a + b * b);
  return {a * scale, b * scale};
}
/// (cos x, sin x) with an error below 2^-49, times v, of about the length 1 again. Requires |x| <= 1.
inline RoundCoordinate turned(const RoundCoordinate& v, double x) {
  return turned_by<double>(v, x, std::fabs(x) > 0.25);
}

/// The angle about the axis and the place along the profile.
struct RoundPlace {
  std::array<RoundCoordinate, 2> at;
};
/// The places whose coordinates differ from those of `centre` by at most `reach`.
struct RoundBox {
  RoundPlace centre;
  std::array<double, 2> reach{};
};

using RoundJet = RoundDerivatives<DoubleBall>;

/// First and second derivative of a position, in the directions away from the axis, around it, and along it.
struct RoundMotion {
  std::array<DoubleBall, 3> velocity, acceleration;
};

/// The points c + rho (cos a e1 + sin a e2) + z e3, in units of a power of two, with orthonormal e, and
///   (rho, z) = (R + r cos b, r sin b) on a torus, (r, b) on a cylinder, (m b, b) on a cone,
/// and on them f = square (N + shift)^2 + p N + q H^2 + t H + constant, the equation of another surface, in
/// terms of N = |P - c'|^2 and H = b'.(P - c'), |b'| = 1. Invariant: the places with b in the range are
/// different points, all that the two surfaces have in common are among them, f has there no zeros but these,
/// and those where H has the wrong sign, and vanishes neither at the ends of the range nor where f = H = 0 or
/// rho = 0.
class RoundChart {
 public:
  /// Empty if neither surface has such a chart, the other one is no round surface, the common points are not
  /// certainly bounded, or an apex is common.
  static std::optional<RoundChart> of(const ImplicitSurface& first, const ImplicitSurface& second);

  /// The second coordinate is an angle as well.
  bool is_closed() const { return balls_.kind == SurfaceKind::torus; }
  /// Of the second coordinate, if it is no angle.
  const std::array<double, 2>& range() const { return range_; }

  /// Of f, for all places in the box.
  RoundJet jet(const RoundBox& box) const;
  RoundJet jet(const RoundPlace& place) const { return jet({place, {}}); }
  DoubleBall value(const RoundPlace& place) const;
  /// The same faster, with radii that are the same for all places of the chart.
  RoundJet quick_jet(const RoundPlace& place) const;
  DoubleBall quick_value(const RoundPlace& place) const {
    return is_quick(place) ? DoubleBall(doubles_.value(angles(place)), errors_.value) : value(place);
  }
  /// All points of the box are on a nappe that does not belong to the other surface.
  bool is_on_other_nappe(const RoundBox& box) const;
  /// 1: all points of the box are on the nappes that belong to the surfaces; -1: none are; 0: not known.
  int side(const RoundBox& box) const;

  /// In space.
  std::array<DoubleBall, 3> position(const RoundBox& box) const;
  std::array<DoubleBall, 3> quick_position(const RoundPlace& place) const {
    if (!is_quick(place)) return position({place, {}});
    const auto [x, y, z] = doubles_.position(angles(place));
    const auto& e = position_errors_;
    return {DoubleBall(x, e[0]), DoubleBall(y, e[1]), DoubleBall(z, e[2])};
  }
  /// Bounds of the lengths of the first derivatives of the position.
  std::array<double, 2> speeds(const RoundBox& box) const;
  /// Of a path with one coordinate as its parameter, and the slope and the bend as the first and second
  /// derivative of the other one.
  RoundMotion motion(const RoundBox& box, std::size_t axis, const DoubleBall& slope,
                     const DoubleBall& bend) const;
  double unit() const { return unit_; }
  /// The numbers of quick values and positions, and the errors of both on a box; infinite if they are not
  /// known.
  const RoundFormula<double>& doubles() const { return doubles_; }
  double value_error(const RoundBox& box) const { return is_quick(box) ? errors_.value : INFINITY; }
  double position_error(const RoundBox& box) const {
    const auto& e = position_errors_;
    return is_quick(box) ? length_bound(e[0], e[1], e[2]) : INFINITY;
  }
  /// The chart is of the second one of the surfaces given, and f the equation of the first one.
  bool is_of_second() const { return is_of_second_; }

  /// a - b by one coordinate; of infinite radius for angles that are not near to each other.
  DoubleBall difference(std::size_t coordinate, const RoundPlace& a, const RoundPlace& b) const;
  /// Certainly |a - b| > reach by one coordinate. Requires reach < 1.
  bool differ(std::size_t coordinate, const RoundPlace& a, const RoundPlace& b, double reach) const {
    const RoundCoordinate &p = a.at[coordinate], &q = b.at[coordinate];
    if (coordinate == 1 && !is_closed()) return std::fabs(p[0] - q[0]) * kReduced > reach;
    // More than 60 degrees, or an angle larger than its sine.
    return p[0] * q[0] + p[1] * q[1] <= 0.5 || std::fabs(p[1] * q[0] - p[0] * q[1]) > reach + 0x1p-48;
  }
  /// The place with one coordinate changed, with an error below 2^-46; angles by at most 1.
  RoundPlace moved(const RoundPlace& from, std::size_t coordinate, double by) const;

 private:
  RoundChart() = default;
  void set_profile(const ImplicitSurface& surface);
  void set_equation(const ImplicitSurface& surface);
  bool set_range(const ImplicitSurface& chart, const ImplicitSurface& other);
  void set_doubles();
  RoundAngles<DoubleBall> angles(const RoundBox& box) const;
  static RoundAngles<double> angles(const RoundPlace& place) { return {place.at[0], place.at[1]}; }

  /// The errors are those of these places, too.
  bool is_quick(const RoundBox& box) const {
    return is_closed() || std::fabs(box.centre.at[1][0]) + box.reach[1] <= quick_reach_;
  }
  bool is_quick(const RoundPlace& place) const { return is_quick({place, {}}); }

  RoundFormula<DoubleBall> balls_;
  RoundFormula<double> doubles_;
  double unit_ = 1;
  std::array<double, 2> range_{};
  // Of quick values and positions, and of the second coordinate of their places if it is no angle.
  double quick_reach_ = 0;
  RoundDerivatives<double> errors_{};
  std::array<double, 3> position_errors_{};
  bool is_of_second_ = false;
  bool is_half_ = false;  // the chart's surface is one nappe, with b >= 0
  bool has_one_nappe_ = false;
};

}  // namespace exsect
