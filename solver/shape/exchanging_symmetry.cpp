#include "shape/exchanging_symmetry.h"

#include <exsect/geometry/pull_back.h>

namespace exsect {

namespace {

/// The affine map from(p_k) = q_k given by four points in general position.
class AffineMapOfSpace {
 public:
  AffineMapOfSpace(const std::array<Point, 4>& from, const std::array<Point, 4>& to)
      : origin_(from[0]), image_(to[0]) {
    for (std::size_t i = 0; i < 3; ++i) {
      from_[i] = from[i + 1] - from[0];
      to_[i] = to[i + 1] - to[0];
    }
  }

  Point operator()(const Point& p) const { return image_ + linear(p - origin_); }
  Point linear(const Point& v) const {
    const Rational all = determinant(from_[0], from_[1], from_[2]);
    return (determinant(v, from_[1], from_[2]) / all) * to_[0] +
           (determinant(from_[0], v, from_[2]) / all) * to_[1] +
           (determinant(from_[0], from_[1], v) / all) * to_[2];
  }

 private:
  Point origin_;
  Point image_;
  std::array<Point, 3> from_;
  std::array<Point, 3> to_;
};

std::array<Point, 9> control_points(const BezierPatch& patch) {
  std::array<Point, 9> result;
  for (std::size_t k = 0; k < 9; ++k) result[k] = patch.net()[k / 3][k % 3];
  return result;
}

/// Four of the points that are in no plane.
std::optional<std::array<std::size_t, 4>> frame_of(const std::array<Point, 9>& p) {
  for (std::size_t i = 1; i < 9; ++i)
    for (std::size_t j = i + 1; j < 9; ++j)
      for (std::size_t k = j + 1; k < 9; ++k)
        if (determinant(p[i] - p[0], p[j] - p[0], p[k] - p[0]) != 0)
          return std::array{std::size_t{0}, i, j, k};
  return std::nullopt;
}

/// The form that is zero at the fixed points of an involution, if these are a plane: A p - p is the form
/// times a vector.
std::optional<AffineForm> fixed_plane(const AffineMapOfSpace& map) {
  std::array<Point, 3> moved;  // the columns of A - 1
  for (std::size_t j = 0; j < 3; ++j) {
    Point axis = {0, 0, 0};
    axis[j] = 1;
    moved[j] = map.linear(axis) - axis;
  }
  if (!is_zero(cross(moved[0], moved[1])) || !is_zero(cross(moved[1], moved[2])) ||
      !is_zero(cross(moved[2], moved[0])))
    return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point normal = {moved[0][k], moved[1][k], moved[2][k]};
    if (!is_zero(normal)) return AffineForm{normal, map({0, 0, 0})[k]};
  }
  return std::nullopt;
}

std::optional<AffineForm> plane_of_exchange(const std::array<Point, 9>& x,
                                            const std::array<std::size_t, 4>& frame,
                                            const std::array<Point, 9>& y) {
  std::array<Point, 4> from;
  std::array<Point, 4> to;
  for (std::size_t i = 0; i < 4; ++i) {
    from[i] = x[frame[i]];
    to[i] = y[frame[i]];
  }
  const AffineMapOfSpace map(from, to);
  for (std::size_t k = 0; k < 9; ++k)
    if (map(x[k]) != y[k] || map(y[k]) != x[k]) return std::nullopt;
  return fixed_plane(map);
}

}  // namespace

std::optional<ExchangingSymmetry> exchanging_symmetry(const BezierPatch& x, const BezierPatch& y) {
  const std::array<Point, 9> of_x = control_points(x);
  const auto frame = frame_of(of_x);
  for (unsigned which = 0; frame && which < 8; ++which) {
    const bool exchanged = (which & 4U) != 0;
    const std::array<bool, 2> reversed = {(which & 1U) != 0, (which & 2U) != 0};
    BezierPatch renamed = exchanged ? y.exchanged() : y;
    if (reversed[0]) renamed = renamed.reversed_first();
    if (reversed[1]) renamed = renamed.reversed_second();
    const auto plane = plane_of_exchange(of_x, *frame, control_points(renamed));
    if (!plane) continue;
    ExchangingSymmetry result{
        {2, 3, 0, 1}, {reversed[0], reversed[1], reversed[0], reversed[1]}, pull_back(*plane, x)};
    if (exchanged) {
      result.partner = {3, 2, 1, 0};
      std::swap(result.reversed[2], result.reversed[3]);
    }
    return result;
  }
  return std::nullopt;
}

}  // namespace exsect
