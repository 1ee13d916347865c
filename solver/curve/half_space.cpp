#include "curve/half_space.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace exsect {
namespace {

using Vector = std::array<double, 3>;

constexpr int kMostDirections = 60;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

/// The point of the convex hull of their directions nearest to zero by Gilbert's method.
std::optional<Point> positive_direction(std::vector<Vector> vectors) {
  for (Vector& w : vectors) {
    const double length = std::sqrt(dot(w, w));
    for (double& c : w) c = length > 1e-30 ? c / length : 0;
  }
  std::erase(vectors, Vector{});
  if (vectors.empty()) return std::nullopt;
  Vector d = {};
  for (const Vector& w : vectors)
    for (std::size_t c = 0; c < 3; ++c) d[c] += w[c] / static_cast<double>(vectors.size());
  double least = 0;
  for (int step = 0; step < kMostDirections; ++step) {
    const Vector& worst = *std::ranges::min_element(vectors, {}, [&](const Vector& w) { return dot(d, w); });
    least = dot(d, worst);
    const Vector away = {d[0] - worst[0], d[1] - worst[1], d[2] - worst[2]};
    const double square = dot(away, away);
    if (least > 0.5 * dot(d, d) || !(square > 0)) break;
    const double length = std::clamp(dot(d, away) / square, 0.0, 1.0);
    for (std::size_t c = 0; c < 3; ++c) d[c] -= length * away[c];
  }
  if (!(least > 0)) return std::nullopt;
  return Point{from_double(d[0]), from_double(d[1]), from_double(d[2])};
}

bool all_positive(const Point& n, const std::vector<Point>& vectors) {
  bool any = false;
  for (const Point& w : vectors) {
    if (is_zero(w)) continue;
    if (exsect::dot(n, w) <= 0) return false;
    any = true;
  }
  return any;
}

bool lie_in_half_space(const std::vector<Point>& vectors) {
  if (std::ranges::any_of(vectors, [](const Point& w) { return is_zero(w); })) return false;
  std::vector<Vector> guesses;
  std::ranges::transform(vectors, std::back_inserter(guesses), [](const Point& p) {
    return Vector{to_double(p[0]), to_double(p[1]), to_double(p[2])};
  });
  const std::optional<Point> n = positive_direction(std::move(guesses));
  return n && all_positive(*n, vectors);
}

}  // namespace exsect
