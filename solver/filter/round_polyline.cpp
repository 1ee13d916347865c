#include "filter/round_polyline.h"

#include <exsect/algebra/interruption.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "filter/round_vertices.h"

namespace exsect {
namespace {

BoundedVertex end_vertex(const RoundChart& chart, const RoundBox& landmark) {
  const auto [x, y, z] = chart.position(landmark);
  return {{{}, {x.approximation(), y.approximation(), z.approximation()}},
          length_bound(x.radius(), y.radius(), z.radius())};
}

/// (17.36): K such that chords over steps h, which add_chords makes as short as K asks for, are within K h^2
/// / 8 of the arc between two nodes.
double deviation(const RoundArc& a, const RoundArc& b, double length, double tolerance) {
  const double all = larger_bound(a.acceleration, b.acceleration), normal = larger_bound(a.normal, b.normal);
  const double least_speed = -larger_bound(-a.least_speed, -b.least_speed);
  return ArcPolyline::deviation(all, normal, least_speed, length, tolerance);
}

/// Draws the pieces of a trace.
class RoundPen {
 public:
  RoundPen(const RoundChart& chart, double tolerance) : chart_(chart), tolerance_(tolerance) {}

  /// What is between the offsets; and the second one, unless it is the trace's last.
  void draw(const RoundTube& tube, double from, double to, bool is_last) {
    wanted_ = tolerance_ / 64 / tube.speed;
    const int parts = parts_of(tube, std::fabs(to - from));
    const double h = (to - from) / parts, half = std::fabs(h) / 2 * kSlack + kMoveError;
    RoundNode last = node(tube, from, tube.slope * from, half);
    for (int k = 1; k <= parts; ++k) {
      const double guess = last.near.off + h * (last.arc.slope + h / 2 * last.arc.bend);
      const RoundNode next = node(tube, k == parts ? to : from + k * h, guess, half);
      draw_part(tube, last, next);
      if (k < parts || !is_last) line.add_vertex(round_vertex(tube, next.near));
      last = next;
    }
  }

  ArcPolyline line;

 private:
  /// Each has bounds of its own; more of them than chords are of no use.
  int parts_of(const RoundTube& tube, double length) const {
    constexpr double chords = 4, most = 4;
    const double size = length * tube.rate;
    return static_cast<int>(
        std::clamp(size / ArcPolyline::step(1 / chart_.unit(), tolerance_) / chords, 1.0, most));
  }

  RoundNode node(const RoundTube& tube, double s, double guess, double half) const {
    const NearCurve near = near_curve(tube, s, guess, wanted_);
    return {s, near, arc_near(tube, near, half)};
  }

  void draw_part(const RoundTube& tube, const RoundNode& a, const RoundNode& b) {
    const double length = std::fabs(b.s - a.s);
    const int count = line.cover_chords(deviation(a.arc, b.arc, length, tolerance_), length, tolerance_);
    RoundPart(tube, a, b, wanted_).add_vertices(count, line);
  }

  const RoundChart& chart_;
  double tolerance_;
  double wanted_ = 0;
};

}  // namespace

ArcPolyline round_polyline(const RoundChart& chart, const RoundTrace& trace, double tolerance) {
  RoundPen pen(chart, tolerance);
  pen.line.add_vertex(end_vertex(chart, trace.ends[0]));
  for (const auto& [tube, range] : trace.pieces) {
    interruption_point();
    pen.draw(tube, range.from(), range.to(), &tube == &trace.pieces.back().tube);
  }
  pen.line.add_vertex(end_vertex(chart, trace.ends[1]));
  return std::move(pen.line);
}

}  // namespace exsect
