// Polylines on round charts: each curve is within the bound of its polyline and that of it, which has few
// more vertices than its curvature asks for.
#include "filter/round_polyline.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "support/catch.h"

namespace exsect::round_polyline_test {
namespace {

using S = ImplicitSurface;
using Vector = std::array<double, 3>;

Vector from_to(const Vector& a, const Vector& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }
double along(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Vector& a) { return std::sqrt(along(a, a)); }
double sine_product(const Vector& a, const Vector& b) {
  return std::sqrt(std::max(0.0, along(a, a) * along(b, b) - along(a, b) * along(a, b)));
}

double distance_to_chord(const Vector& p, const Vector& a, const Vector& b) {
  const Vector chord = from_to(a, b), off = from_to(a, p);
  const double t = std::clamp(along(off, chord) / along(chord, chord), 0.0, 1.0);
  return length(from_to(p, {a[0] + t * chord[0], a[1] + t * chord[1], a[2] + t * chord[2]}));
}

double distance_to(const Vector& p, const std::vector<PolylineVertex>& line) {
  double least = INFINITY;
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
    least = std::min(least, distance_to_chord(p, line[k].point, line[k + 1].point));
  return least;
}

/// The places of a trace in fine steps.
std::vector<Vector> places(const RoundChart& chart, const RoundTrace& trace) {
  std::vector<Vector> result;
  for (const auto& [tube, range] : trace.pieces)
    for (int i = 0; i <= 40; ++i) {
      const double from = range.from(), to = range.to(), s = from + (to - from) * i / 40;
      const auto at = chart.position({near_curve(tube, s, tube.slope * s, 1e-13).place, {}});
      result.push_back({at[0].approximation(), at[1].approximation(), at[2].approximation()});
    }
  return result;
}

/// As many chords as deviations of the curve's own curvature ask for.
double least_count(const std::vector<PolylineVertex>& line, double tolerance) {
  double sum = 0;
  for (std::size_t k = 1; k + 1 < line.size(); ++k) {
    const Vector a = from_to(line[k - 1].point, line[k].point), b = from_to(line[k].point, line[k + 1].point);
    const Vector c = from_to(line[k - 1].point, line[k + 1].point);
    const double curvature = 2 * sine_product(a, b) / (length(a) * length(b) * length(c));
    sum += std::sqrt(curvature / (8 * tolerance)) * length(c) / 2;
  }
  return sum;
}

void check(const RoundChart& chart, double tolerance, double most) {
  const auto landmarks = round_landmarks(chart).value();
  REQUIRE_FALSE(landmarks.empty());
  double needed = 0, used = 0;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const RoundTrace trace = round_trace(chart, landmarks, i).value();
    ArcPolyline polyline = round_polyline(chart, trace, tolerance);
    const double bound = polyline.bound();
    CHECK(bound <= tolerance);
    const std::vector<PolylineVertex> line = polyline.take_vertices();
    double worst = 0;
    for (const Vector& p : places(chart, trace)) worst = std::max(worst, distance_to(p, line));
    CHECK(worst <= bound);
    needed += least_count(line, tolerance);
    used += static_cast<double>(line.size());
  }
  INFO(used << ' ' << needed);
  CHECK(used <= most * needed + 8.0 * static_cast<double>(landmarks.size()));
}

}  // namespace

TEST_CASE("round polyline: keeps its bound and has few vertices") {
  const S torus = S::torus({0, 0, 0}, {1, 2, 3}, 3, 1),
          narrow = S::cylinder({Rational(1, 5), 0, 0}, {1, 1, 0}, 1);
  for (const auto& [a, b] : {std::pair(S::cylinder({0, 0, 0}, {0, 0, 1}, 2), narrow),
                             {torus, narrow},
                             {torus, S::torus({2, 0, 0}, {0, 0, 1}, 2, Rational(3, 4))},
                             {torus, S::cone({0, 0, -4}, {0, 1, 5}, Rational(1, 2))},
                             {S::cone({0, 0, 4}, {0, 0, -1}, Rational(1, 3)), narrow},
                             {torus, S::plane({0, 0, Rational(1, 2)}, {1, 0, 4})}}) {
    INFO(name(a.kind()) << ' ' << name(b.kind()));
    const RoundChart chart = RoundChart::of(a, b).value();
    check(chart, 1e-2, 5);
    check(chart, 1e-4, 2);
    check(chart, 1e-6, 1.6);
  }
}

TEST_CASE("round polyline: doubles that are too rough are seen in the bound") {
  const RoundChart chart =
      RoundChart::of(S::cylinder({0, 0, 0}, {0, 0, 1}, 2), S::cylinder({0, 0, 0}, {1, 0, 0}, 1)).value();
  const auto landmarks = round_landmarks(chart).value();
  const auto trace = round_trace(chart, landmarks, 0).value();
  CHECK(round_polyline(chart, trace, 1e-8).bound() <= 1e-8);
  CHECK(round_polyline(chart, trace, 0x1p-30).bound() <= 0x1p-30);
}

}  // namespace exsect::round_polyline_test
