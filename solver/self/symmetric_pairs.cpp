#include "self/symmetric_pairs.h"

#include <algorithm>
#include <vector>

#include "curve/half_space.h"
#include "shape/self_symmetry.h"

namespace exsect {
namespace {

constexpr int kDeepestSquare = 12;

const Rational one_half(1, 2);

bool is_away(const BezierPatch& n, int depth) {
  std::vector<Point> points;
  for (const auto& row : n.net()) points.insert(points.end(), row.begin(), row.end());
  if (lie_in_half_space(points)) return true;
  if (depth == kDeepestSquare) return false;
  return depth % 2 == 0 ? is_away(n.restricted_to(0, one_half, 0, 1), depth + 1) &&
                              is_away(n.restricted_to(one_half, 1, 0, 1), depth + 1)
                        : is_away(n.restricted_to(0, 1, 0, one_half), depth + 1) &&
                              is_away(n.restricted_to(0, 1, one_half, 1), depth + 1);
}

/// x = y(u + v, u v), y = c00 + c10 s + c20 (s^2 - 2 p) + c11 p + c21 s p + c22 p^2: the cross product of y_s
/// and y_p (7.17) at s = a (1 + b), p = a b, for 0 <= a, b <= 1 the triangle (0,0), (1,0), (2,1).
BezierPatch normals_of_symmetric(const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  const Rational two = 2;
  // Coefficients of 1, a, a b.
  const std::array<Point, 3> s = {c[1][0], two * c[2][0], two * c[2][0] + c[2][1]};
  const std::array<Point, 3> p = {c[1][1] - two * c[2][0], c[2][1], c[2][1] + two * c[2][2]};
  ControlNet normals{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (i > 0 ? 1U : 0U) + (j > 0 ? 1U : 0U);
      const std::size_t b = (i > 1 ? 1U : 0U) + (j > 1 ? 1U : 0U);
      normals[a][b] = normals[a][b] + cross(s[i], p[j]);
    }
  return BezierPatch::from_power_basis(normals);
}

/// A patch around its centre, where only the terms of a^2, a b, b^2, a^2 b^2 are left.
class EvenPatch {
 public:
  EvenPatch(const BezierPatch& x, const PlanePoint& centre)
      : c_(x.restricted_to(centre[0], centre[0] + 1, centre[1], centre[1] + 1).power_basis()) {
    std::array<Rational, 4> corners;
    for (std::size_t i = 0; i < 4; ++i)
      corners[i] = (Rational(i / 2) - centre[0]) * (Rational(i % 2) - centre[1]);
    const auto [least, largest] = std::ranges::minmax(corners);
    k_ = {c_[1][1] + 2 * least * c_[2][2], 2 * (largest - least) * c_[2][2]};
  }

  bool has_only_half_turns() const {
    return is_away_from_origin(normals(c_[2][0], c_[0][2])) &&
           is_away_from_origin(normals(c_[0][2], c_[2][0]));
  }

  /// Of a patch reflected in both diagonals, with one coefficient of a^2 and b^2.
  bool has_only_diagonal_pairs() const {
    ControlNet n{};
    for (std::size_t j = 0; j < 2; ++j) n[0][j] = cross(c_[2][0], k_[j]);
    return is_away_from_origin(BezierPatch::from_power_basis(n));
  }

 private:
  /// (7.18) for the directions (1,m), m = 2 t - 1; the mean of a b is the second parameter.
  BezierPatch normals(const Point& a2, const Point& b2) const {
    ControlNet n{};
    for (std::size_t j = 0; j < 2; ++j) {
      const Point at0 = Rational(2) * cross(a2, k_[j]);
      const Point at1 = j == 0 ? Rational(4) * cross(a2, b2) : Point{0, 0, 0};
      const Point at2 = Rational(2) * cross(k_[j], b2);
      n[0][j] = at0 - at1 + at2;
      n[1][j] = Rational(2) * at1 - Rational(4) * at2;
      n[2][j] = Rational(4) * at2;
    }
    return BezierPatch::from_power_basis(n);
  }

  ControlNet c_;
  /// The coefficient of a b and twice the mean of a b times that of a^2 b^2, over all means: k[0] + k[1] t.
  std::array<Point, 2> k_;
};

}  // namespace

bool has_only_symmetric_pairs(const BezierPatch& x) {
  if (const auto centre = centre_of_symmetry(x)) {
    const EvenPatch even(x, *centre);
    return symmetries(x).size() == 1 ? even.has_only_half_turns() : even.has_only_diagonal_pairs();
  }
  for (const BezierPatch& y : {x, x.reversed_second()})
    if (y == y.exchanged()) return is_away_from_origin(normals_of_symmetric(y));
  return false;
}

bool is_away_from_origin(const BezierPatch& n) { return is_away(n, 0); }

}  // namespace exsect
