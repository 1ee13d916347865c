#include "answer/rim_arc.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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

/// Without its polyline and bound.
Arc empty_rim(const RimEnd& from, const RimEnd& to, ArcPlace place) {
  Arc arc{};
  arc.component = -1;
  arc.from = from.node;
  arc.to = to.node;
  arc.place = place;
  arc.contact = Contact::tangential;
  return arc;
}

/// How many chords keep within the tolerance, by a bound of the second derivative.
int rim_chords(double second, double tolerance) {
  return tolerance > 0 ? chord_count(std::ceil(std::sqrt(second / (8 * 0.9 * tolerance)))) : 1;
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
  const int n = rim_chords(second, tolerance);
  Arc arc = empty_rim(from, to, place);
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

namespace {

using Vectors = std::vector<HomogeneousPoint>;

HomogeneousPoint mean(const HomogeneousPoint& a, const HomogeneousPoint& b, const Rational& t) {
  HomogeneousPoint result;
  for (std::size_t k = 0; k < 4; ++k) result[k] = (1 - t) * a[k] + t * b[k];
  return result;
}

/// The control vectors of the curve over [lower,upper]: blossoms of those over [0,1].
Vectors restricted(const Vectors& curve, const Rational& lower, const Rational& upper) {
  Vectors result;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    Vectors b = curve;
    for (std::size_t level = 1; level < curve.size(); ++level) {
      const Rational& t = level <= k ? upper : lower;
      for (std::size_t i = 0; i + level < curve.size(); ++i) b[i] = mean(b[i], b[i + 1], t);
    }
    result.push_back(b[0]);
  }
  return result;
}

/// Over the segment, on which one parameter is constant.
Vectors rim_vectors(const RationalPatch& patch, const std::array<Rational, 4>& from,
                    const std::array<Rational, 4>& to) {
  const std::size_t along = from[0] == to[0] ? 1 : 0;
  const RationalPatch x = along == 1 ? patch : patch.transposed();
  Vectors line;
  for (int j = 0; j <= x.degree_v(); ++j) {
    Vectors across;
    for (int i = 0; i <= x.degree_u(); ++i) across.push_back(x.homogeneous(i, j));
    line.push_back(restricted(across, from[1 - along], from[1 - along])[0]);
  }
  return restricted(line, from[along], to[along]);
}

/// Of |p''| for p = m + N / w on one piece of the line, with bounds of N, w and their derivatives by control
/// vectors about the middle m and their differences: p' = (N' - w' (p - m)) / w, p'' = (N'' - 2 w' p' - w''
/// (p - m)) / w. `pieces` is how often the piece is in the line.
double second_derivative(Vectors c, int pieces) {
  const HomogeneousPoint middle = c[c.size() / 2];
  double least = std::numeric_limits<double>::infinity();
  for (HomogeneousPoint& p : c) {
    if (!(p[3] > 0)) return std::numeric_limits<double>::infinity();
    least = std::min(least, to_double(p[3]));
    for (std::size_t k = 0; k < 3; ++k) p[k] -= middle[k] / middle[3] * p[3];
  }
  std::array<double, 3> space{};
  std::array<double, 3> weight{};
  double factor = 1;
  for (std::size_t order = 0; order < 3 && order < c.size(); ++order) {
    for (std::size_t k = 0; k + order < c.size(); ++k) {
      space[order] = larger_bound(space[order], factor * length({c[k][0], c[k][1], c[k][2]}));
      weight[order] = larger_bound(weight[order], factor * std::fabs(to_double(c[k][3])));
    }
    factor *= pieces * static_cast<double>(c.size() - 1 - order);
    for (std::size_t k = 0; k + 1 + order < c.size(); ++k)
      for (std::size_t i = 0; i < 4; ++i) c[k][i] = c[k + 1][i] - c[k][i];
  }
  const double off = space[0] / least;
  const double rate = (space[1] + weight[1] * off) / least;
  return kSlack * (space[2] + 2 * weight[1] * rate + weight[2] * off) / least;
}

}  // namespace

/// A vertex: control vectors err by one u of their size M, and each mean by three, so that numerator and
/// denominator err by 10 u M at most, and the quotient by one u more.
Arc rim_arc(const RationalPatch& x, const RimEnd& from, const RimEnd& to, ArcPlace place, double tolerance) {
  if (const auto patch = x.biquadratic()) return rim_arc(*patch, from, to, place, tolerance);
  constexpr int kPieces = 16;
  constexpr double kMeans = 12 * kUnitRoundoff;
  const Vectors line = rim_vectors(x, from.at, to.at);
  double second = 0;
  for (int i = 0; i < kPieces; ++i) {
    const Vectors piece = restricted(line, Rational(i, kPieces), Rational(i + 1, kPieces));
    second = larger_bound(second, second_derivative(piece, kPieces));
  }
  std::vector<std::array<double, 4>> points;
  double largest = 0;
  double greatest_weight = 0;
  for (const HomogeneousPoint& p : line) {
    points.push_back({to_double(p[0]), to_double(p[1]), to_double(p[2]), to_double(p[3])});
    for (std::size_t k = 0; k < 3; ++k) largest = larger_bound(largest, std::fabs(points.back()[k]));
    greatest_weight = larger_bound(greatest_weight, std::fabs(points.back()[3]));
  }
  const int n = rim_chords(second, tolerance);
  Arc arc = empty_rim(from, to, place);
  double vertex_error = 0;
  for (int i = 0; i <= n; ++i) {
    const double t = static_cast<double>(i) / n;
    auto b = points;
    for (std::size_t level = 1; level < b.size(); ++level)
      for (std::size_t j = 0; j + level < b.size(); ++j)
        for (std::size_t k = 0; k < 4; ++k) b[j][k] = (1 - t) * b[j][k] + t * b[j + 1][k];
    PolylineVertex& vertex = arc.polyline.emplace_back();
    for (std::size_t j = 0; j < 4; ++j)
      vertex.parameters[j] = std::lerp(to_double(from.at[j]), to_double(to.at[j]), t);
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      vertex.point[k] = b[0][k] / b[0][3];
      size = larger_bound(size, std::fabs(vertex.point[k]));
    }
    const double weight = b[0][3] - kMeans * greatest_weight;
    const double error = kMeans * (largest + size * greatest_weight) / weight + 2 * kUnitRoundoff * size;
    vertex_error = larger_bound(vertex_error, weight > 0 ? error : std::numeric_limits<double>::infinity());
  }
  const double step = 1.0 / n + 0x1p-51;
  // Both ends of a chord, 7/4 being more than the square root of 3.
  arc.error_bound = kSlack * (second * step * step / 8 + 2 * 1.75 * vertex_error + kUnderflowLoss);
  return arc;
}

}  // namespace exsect
