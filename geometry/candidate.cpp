#include "candidate.h"

#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace exsect {

SplineCurve polyline(std::vector<std::array<double, 3>> vertices) {
  if (vertices.size() < 2) throw std::invalid_argument("a polyline has at least two vertices");
  std::vector<double> knots = {0};
  for (std::size_t i = 0; i < vertices.size(); ++i) knots.push_back(static_cast<double>(i));
  knots.push_back(knots.back());
  return {1, std::move(knots), std::move(vertices), {}};
}

std::array<double, 3> point_of(const SplineCurve& curve, double t) {
  return in_nearest_rounding([&]() -> std::array<double, 3> {
    const auto d = static_cast<std::size_t>(curve.degree);
    const auto first = curve.knots.begin() + curve.degree;
    const auto last = curve.knots.begin() + static_cast<std::ptrdiff_t>(curve.points.size());
    auto k = static_cast<std::size_t>(std::upper_bound(first, last, t) - curve.knots.begin()) - 1;
    while (curve.knots[k] == curve.knots[k + 1]) --k;  // t is the end of the last span
    // Of weights only the ratios matter: by one power of two the greatest is near 1.
    const auto begin =
        curve.weights.begin() + (curve.weights.empty() ? 0 : static_cast<std::ptrdiff_t>(k - d));
    const int scale =
        curve.weights.empty() ? 0 : std::ilogb(*std::max_element(begin, begin + curve.degree + 1));
    std::vector<std::array<double, 4>> net;
    for (std::size_t i = k - d; i <= k; ++i) {
      const double w = curve.weights.empty() ? 1 : std::ldexp(curve.weights[i], -scale);
      const auto& p = curve.points[i];
      net.push_back({w * p[0], w * p[1], w * p[2], w});
    }
    for (std::size_t level = 1; level <= d; ++level) {
      for (std::size_t i = d; i >= level; --i) {
        const double a = curve.knots[k - d + i];
        const double b = curve.knots[k + i + 1 - level];
        for (std::size_t c = 0; c < 4; ++c)
          net[i][c] = ((b - t) * net[i - 1][c] + (t - a) * net[i][c]) / (b - a);
      }
    }
    const auto& p = net[d];
    return {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
  });
}

Candidate exchanged(Candidate candidate) {
  for (CandidateCurve& curve : candidate.curves) std::swap(curve.first, curve.second);
  for (CandidatePoint& point : candidate.points) std::swap(point.first, point.second);
  return candidate;
}

std::string violation(const SplineCurve& curve) {
  const std::size_t n = curve.points.size();
  if (curve.degree < 1) return "the degree must be at least 1";
  const auto d = static_cast<std::size_t>(curve.degree);
  if (n < d + 1)
    return "degree " + std::to_string(d) + " needs at least " + std::to_string(d + 1) + " points";
  if (curve.knots.size() != n + d + 1)
    return "there must be " + std::to_string(n + d + 1) + " knots (points + degree + 1)";
  const auto small = [](double x) { return std::fabs(x) <= max_candidate_number; };
  if (!std::all_of(curve.knots.begin(), curve.knots.end(), small)) return "a knot is beyond 2^500";
  if (!std::is_sorted(curve.knots.begin(), curve.knots.end())) return "the knots must ascend";
  if (!(curve.from() < curve.to())) return "the parameter interval must not be empty";
  for (std::size_t i = 1; i + d < n + d; ++i)
    if (curve.knots[i] == curve.knots[i + d] && curve.knots[i] > curve.from() && curve.knots[i] < curve.to())
      return "an interior knot may occur at most " + std::to_string(d) + " times";
  for (const auto& point : curve.points)
    if (!std::all_of(point.begin(), point.end(), small)) return "a coordinate is beyond 2^500";
  if (!curve.weights.empty() && curve.weights.size() != n) return "there must be as many weights as points";
  for (const double weight : curve.weights)
    if (!(weight > 0) || !std::isfinite(weight)) return "a weight must be > 0";
  return "";
}

}  // namespace exsect
