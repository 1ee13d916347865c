#include "rim_arc.h"

#include <algorithm>
#include <cmath>

namespace exsect {
namespace {

double length(const Point& v) { return std::hypot(to_double(v[0]), to_double(v[1]), to_double(v[2])); }

PolylineVertex vertex(const BezierPatch& x, const std::array<Rational, 4>& at) {
  PolylineVertex result{};
  const Point p = x(at[0], at[1]);
  for (std::size_t j = 0; j < 4; ++j) result.parameters[j] = to_double(at[j]);
  for (std::size_t k = 0; k < 3; ++k) result.point[k] = to_double(p[k]);
  return result;
}

}  // namespace

/// On the segment x is p(t) = a0 + a1 t + a2 t^2, 0 <= t <= 1: a chord over a step h deviates by |2 a2| h^2
/// / 8. The bound adds the rounding of both ends' coordinates and covers its own rounding (2^-40).
Arc rim_arc(const BezierPatch& x, const RimEnd& from, const RimEnd& to, ArcPlace place, double tolerance) {
  const auto at = [&](const Rational& t) {
    std::array<Rational, 4> result;
    for (std::size_t j = 0; j < 4; ++j) result[j] = from.at[j] + t * (to.at[j] - from.at[j]);
    return result;
  };
  const auto middle = at(Rational(1, 2));
  const Point a2 = Rational(2) * (x(from.at[0], from.at[1]) - Rational(2) * x(middle[0], middle[1]) +
                                  x(to.at[0], to.at[1]));
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
  for (int i = 0; i <= n; ++i) {
    arc.polyline.push_back(vertex(x, at(Rational(i, n))));
    const std::array<double, 3>& p = arc.polyline.back().point;
    largest = std::max(largest, std::hypot(p[0], p[1], p[2]));
  }
  const double step = 1.0 / n;
  arc.error_bound = (second * step * step / 8 + largest * 0x1p-50) * (1 + 0x1p-40);
  return arc;
}

}  // namespace exsect
