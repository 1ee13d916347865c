#include "answer/rim_arc.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "answer/chord_count.h"

namespace exsect {
namespace {

double length(const Point& v) { return std::hypot(to_double(v[0]), to_double(v[1]), to_double(v[2])); }

constexpr std::size_t kDegree = 4;  // of a patch along any straight line

/// The control points of x on the segment, and the parameters at its ends, in doubles.
struct Segment {
  std::array<std::array<double, 3>, kDegree + 1> points;
  std::array<std::array<double, 4>, 2> parameters;

  /// Each coordinate of the point errs by less than 16 u times the largest one of the control points: one u
  /// for these, three for each of the four means.
  PolylineVertex vertex(double t) const {
    PolylineVertex result{};
    for (std::size_t j = 0; j < 4; ++j)
      result.parameters[j] = std::lerp(parameters[0][j], parameters[1][j], t);
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<double, kDegree + 1> b{};
      for (std::size_t i = 0; i <= kDegree; ++i) b[i] = points[i][k];
      for (std::size_t n = kDegree; n > 0; --n)
        for (std::size_t i = 0; i < n; ++i) b[i] = (1 - t) * b[i] + t * b[i + 1];
      result.point[k] = b[0];
    }
    return result;
  }
};

using ControlPoints = std::array<Point, kDegree + 1>;

/// From the values at t = 0, 1/4, ..., 1.
ControlPoints arc_control_points(const BezierPatch& x, const std::array<Rational, 4>& from,
                                 const std::array<Rational, 4>& to) {
  ControlPoints p;
  for (std::size_t i = 0; i <= kDegree; ++i) {
    const Rational t(i, kDegree);
    p[i] = x((1 - t) * from[0] + t * to[0], (1 - t) * from[1] + t * to[1]);
  }
  const auto combined = [&](const std::array<int, kDegree + 1>& factors, int divisor) {
    Point sum = {0, 0, 0};
    for (std::size_t i = 0; i <= kDegree; ++i) sum = sum + Rational(factors[i], divisor) * p[i];
    return sum;
  };
  return {p[0], combined({-13, 48, -36, 16, -3}, 12), combined({13, -64, 120, -64, 13}, 18),
          combined({-3, 16, -36, 48, -13}, 12), p[4]};
}

std::array<double, 3> rounded(const Point& p) { return {to_double(p[0]), to_double(p[1]), to_double(p[2])}; }

}  // namespace

Node rim_node(const std::array<Rational, 4>& at) {
  Node node{};
  node.kinds = {NodeKind::boundary};
  std::array<int, 2> sides = {0, 0};
  for (std::size_t j = 0; j < 4; ++j) {
    if (at[j] == 0 || at[j] == 1) {
      node.on.push_back({static_cast<Parameter>(j), at[j] == 0 ? 0 : 1});
      ++sides[j / 2];
    }
    node.box[j] = {at[j], at[j]};
    node.approx[j] = to_double(at[j]);
  }
  if (sides[0] == 2 || sides[1] == 2) node.kinds.push_back(NodeKind::corner);
  return node;
}

/// On the segment x is a quartic p(t), 0 <= t <= 1, and p'' between 12 times the second differences of its
/// control points: a chord over a step h deviates by at most |p''| h^2 / 8. The bound adds the rounding of
/// both ends' coordinates and covers its own rounding (2^-40).
Arc rim_arc(const BezierPatch& x, const RimEnd& from, const RimEnd& to, ArcPlace place, double tolerance) {
  const ControlPoints control = arc_control_points(x, from.at, to.at);
  Segment segment{};
  for (std::size_t i = 0; i <= kDegree; ++i) segment.points[i] = rounded(control[i]);
  for (std::size_t j = 0; j < 4; ++j) {
    segment.parameters[0][j] = to_double(from.at[j]);
    segment.parameters[1][j] = to_double(to.at[j]);
  }
  double second = 0;
  for (std::size_t i = 0; i + 2 <= kDegree; ++i)
    second = larger_bound(second, 12 * length(control[i] - Rational(2) * control[i + 1] + control[i + 2]));
  const double wanted = std::ceil(std::sqrt(second / (8 * 0.9 * tolerance)));
  const int n = tolerance > 0 ? chord_count(wanted) : 1;
  Arc arc{};
  arc.component = -1;
  arc.from = from.node;
  arc.to = to.node;
  arc.place = place;
  arc.contact = Contact::tangential;
  double largest = 0;
  for (const auto& p : segment.points)
    for (const double c : p) largest = larger_bound(largest, std::fabs(c));
  arc.polyline.reserve(static_cast<std::size_t>(n) + 1);
  for (int i = 0; i <= n; ++i) arc.polyline.push_back(segment.vertex(static_cast<double>(i) / n));
  const double step = 1.0 / n + 0x1p-51;
  // 2^-47 = 64 u: 16 u times the square root of 3 at both ends of a chord.
  arc.error_bound = (second * step * step / 8 + largest * 0x1p-47) * kSlack;
  return arc;
}

}  // namespace exsect
