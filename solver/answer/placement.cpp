#include "answer/placement.h"

#include <exsect/algebra/binary_order.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace exsect {

namespace {

/// Beyond these powers of two of the extent, and of the largest coordinate over the extent, a model is moved.
constexpr long kLargestExponent = 64;
constexpr long kFarthest = 10;
/// The origin is a multiple of this power of two of the extent: short, so that coordinates do not get longer.
constexpr long kOriginBits = 12;

/// The least n with |q| < 2^n. Requires q != 0.
long binary_exponent(const Rational& q) {
  const long n = binary_order(q);
  return abs(q) < power_of_two(n) ? n : n + 1;
}

struct Box {
  Point lower;
  Point upper;

  explicit Box(std::span<const Point> points) : lower(points.front()), upper(lower) {
    for (const Point& p : points)
      for (std::size_t c = 0; c < 3; ++c) {
        lower[c] = std::min(lower[c], p[c]);
        upper[c] = std::max(upper[c], p[c]);
      }
  }

  Rational extent() const {
    return std::max(
        {Rational(upper[0] - lower[0]), Rational(upper[1] - lower[1]), Rational(upper[2] - lower[2])});
  }
  /// The largest |coordinate|.
  Rational reach() const {
    Rational result = 0;
    for (const Point* p : {&lower, &upper})
      for (const Rational& c : *p) result = std::max(result, Rational(abs(c)));
    return result;
  }
};

/// The multiple of 2^exponent next below q.
Rational floor_to(const Rational& q, long exponent) {
  const Rational scaled = q * power_of_two(-exponent);
  Integer whole = numerator(scaled) / denominator(scaled);
  if (whole > scaled) --whole;
  return Rational(whole) * power_of_two(exponent);
}

std::vector<Point> control_points(const BezierPatch& x, const BezierPatch& y) {
  std::vector<Point> points;
  for (const BezierPatch* patch : {&x, &y})
    for (const auto& row : patch->net()) points.insert(points.end(), row.begin(), row.end());
  return points;
}

}  // namespace

Rational model_extent(const BezierPatch& x, const BezierPatch& y) {
  return model_extent(control_points(x, y));
}
Rational model_extent(std::span<const Point> points) { return Box(points).extent(); }

std::vector<Point> affine_points(const RationalPatch& patch) {
  std::vector<Point> points;
  for (int i = 0; i <= patch.degree_u(); ++i)
    for (int j = 0; j <= patch.degree_v(); ++j)
      if (patch.weight(i, j) > 0) points.push_back(patch.point(i, j));
  return points;
}

Placement::Placement(Point origin, long exponent)
    : origin_(std::move(origin)), exponent_(exponent), scale_(power_of_two(exponent)) {
  for (std::size_t c = 0; c < 3; ++c) {
    high_[c] = to_double(origin_[c]);
    low_[c] = std::isfinite(high_[c]) ? to_double(origin_[c] - from_double(high_[c])) : 0;
  }
}

std::optional<Placement> Placement::of(const BezierPatch& x, const BezierPatch& y) {
  return of(control_points(x, y));
}

std::optional<Placement> Placement::of(std::span<const Point> points) {
  const Box box(points);
  const Rational reach = box.reach();
  if (reach == 0) return std::nullopt;
  const Rational extent = box.extent();
  const long exponent = extent == 0 ? 0 : binary_exponent(extent);
  const bool is_near = reach <= (extent == 0 ? Rational(1) : extent) * power_of_two(kFarthest);
  if (is_near && std::abs(exponent) <= kLargestExponent) return std::nullopt;
  Point origin;
  for (std::size_t c = 0; c < 3; ++c)
    origin[c] =
        extent == 0 ? box.lower[c] : floor_to((box.lower[c] + box.upper[c]) / 2, exponent - kOriginBits);
  return Placement(std::move(origin), exponent);
}

BezierPatch Placement::placed(const BezierPatch& patch) const {
  ControlNet net = patch.net();
  for (auto& row : net)
    for (Point& p : row) p = placed(p);
  return BezierPatch(net);
}

RationalPatch Placement::placed(const RationalPatch& patch) const {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (int i = 0; i <= patch.degree_u(); ++i) {
    net.emplace_back();
    for (int j = 0; j <= patch.degree_v(); ++j) {
      HomogeneousPoint p = patch.homogeneous(i, j);
      for (std::size_t c = 0; c < 3; ++c) p[c] = power_of_two(-exponent_) * (p[c] - p[3] * origin_[c]);
      net.back().push_back(std::move(p));
    }
  }
  return RationalPatch::from_homogeneous(net);
}

ImplicitSurface Placement::placed(const ImplicitSurface& surface) const {
  return surface.seen_from(origin_, scale_);
}

Point Placement::placed(const Point& point) const { return power_of_two(-exponent_) * (point - origin_); }

double Placement::left_of(double tolerance) const {
  double rounding = 0;  // as in restore(), where the extent is 1/2
  for (const double high : high_)
    rounding += (std::fabs(std::ldexp(high, static_cast<int>(-exponent_))) + 4) * 0x1p-50;
  return std::max(tolerance - rounding, 0.5 * tolerance);
}

/// What the scaling loses below the normal range, in user's coordinates.
constexpr double kRestoring = 0x1p-1072;

/// A coordinate is fl(high + fl(low + fl(2^exponent q))). Each sum errs by at most 2^-53 of its value and the
/// origin by 2^-106 of its own, which 2^-52 of both sums covers; below the normal range sums are exact, and
/// the scaling, `low` and the lost part of the origin err by 2^-1075 each: 2^-1072 for three coordinates.
double Placement::restore(std::array<double, 3>& point) const {
  double error = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double rest = low_[c] + std::ldexp(point[c], static_cast<int>(exponent_));
    point[c] = high_[c] + rest;
    error += (std::fabs(point[c]) + std::fabs(rest)) * 2 * kUnitRoundoff;
  }
  return error + kRestoring;
}

void Placement::restore(Arc& arc) const {
  double moved = 0;
  for (PolylineVertex& vertex : arc.polyline) {
    const double error = restore(vertex.point);
    moved = larger_bound(moved, error);
  }
  arc.error_bound = restored(arc.error_bound, moved);
}

double Placement::restored(double bound, double moved) const {
  const double sum = std::ldexp(bound, static_cast<int>(exponent_)) + moved;
  return std::isfinite(sum) ? sum * kSlack + kRestoring : HUGE_VAL;
}

Point Placement::restored(const Point& point) const { return origin_ + scale_ * point; }

void Placement::restore(IntersectionGraph& graph) const {
  for (Node& node : graph.nodes) restore(node.point);
  for (Arc& arc : graph.arcs) restore(arc);
  for (Overlap& overlap : graph.overlaps)
    for (std::vector<Arc>& chain : overlap.chains)
      for (Arc& arc : chain) restore(arc);
}

}  // namespace exsect
