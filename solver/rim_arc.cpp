#include "rim_arc.h"

#include <algorithm>
#include <cmath>

namespace exsect {
namespace {

double length(const Point& v) { return std::hypot(to_double(v[0]), to_double(v[1]), to_double(v[2])); }

/// The control points of x on the segment, and the parameters at its ends, in doubles.
struct Segment {
  std::array<std::array<double, 3>, 3> points;
  std::array<std::array<double, 4>, 2> parameters;

  /// Each coordinate of the point errs by less than 8 u times the largest one of the control points: one u
  /// for these, two for each of the two means, one for t = i/n in each difference.
  PolylineVertex vertex(double t) const {
    PolylineVertex result{};
    for (std::size_t j = 0; j < 4; ++j)
      result.parameters[j] = std::lerp(parameters[0][j], parameters[1][j], t);
    for (std::size_t k = 0; k < 3; ++k) {
      const double first = (1 - t) * points[0][k] + t * points[1][k];
      const double last = (1 - t) * points[1][k] + t * points[2][k];
      result.point[k] = (1 - t) * first + t * last;
    }
    return result;
  }
};

std::array<double, 3> rounded(const Point& p) { return {to_double(p[0]), to_double(p[1]), to_double(p[2])}; }

}  // namespace

/// On the segment x is p(t) = a0 + a1 t + a2 t^2, 0 <= t <= 1: a chord over a step h deviates by |2 a2| h^2
/// / 8. The bound adds the rounding of both ends' coordinates and covers its own rounding (2^-40).
Arc rim_arc(const BezierPatch& x, const RimEnd& from, const RimEnd& to, ArcPlace place, double tolerance) {
  const Rational half(1, 2);
  const Point start = x(from.at[0], from.at[1]);
  const Point end = x(to.at[0], to.at[1]);
  const Point middle = x(half * (from.at[0] + to.at[0]), half * (from.at[1] + to.at[1]));
  const Point a2 = Rational(2) * (start - Rational(2) * middle + end);
  const Point control = Rational(2) * middle - half * (start + end);
  Segment segment{{rounded(start), rounded(control), rounded(end)}, {}};
  for (std::size_t j = 0; j < 4; ++j) {
    segment.parameters[0][j] = to_double(from.at[j]);
    segment.parameters[1][j] = to_double(to.at[j]);
  }
  const double second = 2 * length(a2);
  const double wanted = std::ceil(std::sqrt(second / (8 * 0.9 * tolerance)));
  const int n = tolerance > 0 ? static_cast<int>(std::clamp(wanted, 1.0, 1e6)) : 1;
  Arc arc{};
  arc.component = -1;
  arc.from = from.node;
  arc.to = to.node;
  arc.place = place;
  arc.contact = Contact::tangential;
  double largest = 0;
  for (const auto& p : segment.points)
    for (const double c : p) largest = std::max(largest, std::fabs(c));
  arc.polyline.reserve(static_cast<std::size_t>(n) + 1);
  for (int i = 0; i <= n; ++i) arc.polyline.push_back(segment.vertex(static_cast<double>(i) / n));
  const double step = 1.0 / n + 0x1p-51;
  // 2^-48 = 32 u: 8 u times the square root of 3 at both ends of a chord.
  arc.error_bound = (second * step * step / 8 + largest * 0x1p-48) * (1 + 0x1p-40);
  return arc;
}

}  // namespace exsect
