#include "filter/round_polyline.h"

#include <exsect/algebra/interruption.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "trace/bounded_vertex.h"

namespace exsect {
namespace {

/// A place of the curve, and what is known around it.
struct RoundNode {
  double s;
  NearCurve near;
  RoundArc arc;
};

/// About the other coordinate between two nodes: the polynomial of degree 5 with its values, slopes and
/// bends.
class NodeCurve {
 public:
  NodeCurve(const RoundNode& a, const RoundNode& b) : from_(a.s), length_(b.s - a.s) {
    const double h = length_;
    c_ = {a.near.off, a.arc.slope * h, a.arc.bend * h * h / 2};
    const double value = b.near.off - (c_[0] + c_[1] + c_[2]), slope = b.arc.slope * h - (c_[1] + 2 * c_[2]),
                 bend = b.arc.bend * h * h - 2 * c_[2];
    c_[3] = 10 * value - 4 * slope + bend / 2;
    c_[4] = -15 * value + 7 * slope - bend;
    c_[5] = 6 * value - 3 * slope + bend / 2;
  }

  double operator()(double s) const {
    const double x = (s - from_) / length_;
    return c_[0] + x * (c_[1] + x * (c_[2] + x * (c_[3] + x * (c_[4] + x * c_[5]))));
  }

 private:
  double from_, length_;
  std::array<double, 6> c_;
};

BoundedVertex vertex(const std::array<DoubleBall, 3>& at, double error) {
  BoundedVertex v{{{}, {at[0].approximation(), at[1].approximation(), at[2].approximation()}}, 0};
  v.error = (at[0].radius() + at[1].radius() + at[2].radius() + error) * kSlack;
  return v;
}

/// (17.36): K such that chords over steps h, which add_chords makes as short as K asks for, are within K h^2
/// / 8 of the arc between two nodes.
double deviation(const RoundArc& a, const RoundArc& b, double length, double tolerance) {
  const double all = larger_bound(a.acceleration, b.acceleration), normal = larger_bound(a.normal, b.normal);
  const double least_speed = -larger_bound(-a.least_speed, -b.least_speed);
  const double step = std::min(length, ArcPolyline::step(normal, tolerance)) * kSlack;
  const double turn = all * step / (2 * least_speed) * kSlack;
  const double across = (normal + all * turn) * kSlack;
  return step * (kMostChords / 2) > length && turn < 0.5 && across < all ? across : all;
}

/// Draws the pieces of a trace.
class RoundPen {
 public:
  RoundPen(const RoundChart& chart, double tolerance) : chart_(chart), tolerance_(tolerance) {}

  /// What is between the offsets; and the second one, unless it is the trace's last.
  void draw(const RoundTube& tube, double from, double to, bool is_last) {
    wanted_ = tolerance_ / 64 / tube.speed;
    const int parts = parts_of(tube, std::fabs(to - from));
    const double h = (to - from) / parts, half = std::fabs(h) / 2 * kSlack + kOffsetError;
    RoundNode last = node(tube, from, tube.slope * from, half);
    for (int k = 1; k <= parts; ++k) {
      const double guess = last.near.off + h * (last.arc.slope + h / 2 * last.arc.bend);
      const RoundNode next = node(tube, k == parts ? to : from + k * h, guess, half);
      draw_part(tube, last, next);
      if (k < parts || !is_last) line.add_vertex(vertex_of(tube, next.near));
      last = next;
    }
  }

  ArcPolyline line;

 private:
  static constexpr double kOffsetError = 0x1p-45;  // of the places of vertices

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
    const NodeCurve guess(a, b);
    line.add_chords(deviation(a.arc, b.arc, std::fabs(b.s - a.s), tolerance_), a.s, b.s, tolerance_,
                    [&](double s) {
                      const double off = guess(s);
                      const auto near = next_to(tube, a.near, a.s, s, off, wanted_);
                      return vertex_of(tube, near ? *near : near_curve(tube, s, off, wanted_));
                    });
  }

  BoundedVertex vertex_of(const RoundTube& tube, const NearCurve& near) const {
    return vertex(chart_.quick_position(near.place), near.error * tube.speed + kOffsetError * tube.rate);
  }

  const RoundChart& chart_;
  double tolerance_;
  double wanted_ = 0;
};

}  // namespace

ArcPolyline round_polyline(const RoundChart& chart, const RoundTrace& trace, double tolerance) {
  RoundPen pen(chart, tolerance);
  pen.line.add_vertex(vertex(chart.position(trace.ends[0]), 0));
  for (const auto& [tube, range] : trace.pieces) {
    interruption_point();
    pen.draw(tube, range.from(), range.to(), &tube == &trace.pieces.back().tube);
  }
  pen.line.add_vertex(vertex(chart.position(trace.ends[1]), 0));
  return std::move(pen.line);
}

}  // namespace exsect
