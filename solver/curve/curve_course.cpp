#include "curve/curve_course.h"

#include <exsect/algebra/interruption.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "curve/curve_place.h"
#include "curve/plane_strip.h"

namespace exsect {
namespace {

/// The shares of a tolerance: the strip, and the chord in space.
constexpr double kStripShare = 0.55;
constexpr double kChordShare = 0.3;
/// The greatest half width of strips in v.
constexpr double kWidestStrip = 0x1p-9;
/// Bounds of derivatives are for what is as near as this to a chord: more than strips, and moved ends.
constexpr double kNear = 0x1p-8;
constexpr double kLongestStep = 0x1p-3;
/// After so many halved steps arcs are told apart exactly.
constexpr int kPatience = 8;
/// Steps shorter than this, in doubles and with more bits, are left to longer numbers.
constexpr double kLeastStep = 0x1p-46;
constexpr double kLeastLongStep = 0x1p-900;

/// NaN, with which nothing is proved, where bounds of derivatives are beyond doubles.
double strip_width(const PatchRates& rates, double tolerance) {
  const double w = kStripShare * tolerance / rates.v;
  return w > kWidestStrip ? kWidestStrip : w;
}

/// Where the drawing of an arc has come: the arc over u is within `reach` of v.
struct Front {
  Rational u;
  Rational v;
  double reach;
};

/// A point (u,v) of the square.
using Vertex = std::array<DoubleBall, 2>;
Vertex vertex_at(const Rational& u, const Rational& v) {
  return {DoubleBall::enclosing(u), DoubleBall::enclosing(v)};
}
Vertex vertex_at(const DoubleBall& u, const DoubleBall& v) { return {u, v}; }
template <class Ball>
Vertex vertex_at(const Ball& u, const Ball& v) {
  return vertex_at(u.interval().lower, v.interval().lower);
}

/// What is drawn of an arc from a place inside it to one of its nodes.
struct HalfCourse {
  std::vector<Vertex> vertices;
  double bound = 0;  // of the distance in space between arc and chords
};

/// Follows one arc from a front to a node.
class Follower {
 public:
  Follower(const CurveGraph& graph, std::size_t arc, const NodePlace& node, const DrawnPatch& patch,
           double tolerance)
      : graph_(graph), arc_(arc), node_(node), patch_(patch), tolerance_(tolerance) {
    use(patch.rates());
  }

  HalfCourse run(Front front) {
    if (!follow<DoubleBall>(front, kLeastStep) && !follow<ArbBall<256>>(front, 0x1p-200) &&
        !follow<ArbBall<1024>>(front, kLeastLongStep))
      throw ProofFailure(whole_domain(), "an arc of a plane curve cannot be drawn");
    return std::move(course_);
  }

 private:
  /// Bounds for the next chord, and what follows from them.
  void use(const PatchRates& rates) {
    rates_ = rates;
    widest_ = strip_width(rates, tolerance_);
    steepness_ = graph_.is_monotone_in_v ? rates.v / rates.u : 0;
    if (!std::isfinite(steepness_)) steepness_ = 0;
  }

  PatchRates rates_near(double u0, double u1, double v0, double v1) const {
    return patch_.rates_in(std::min(u0, u1) - kNear, std::max(u0, u1) + kNear, std::min(v0, v1) - kNear,
                           std::max(v0, v1) + kNear);
  }

  template <class Ball>
  static Ball rounded(const Rational& q) {
    return Ball::enclosing(q).midpoint();
  }
  template <class Ball>
  static Rational exact(const Ball& ball) {
    return ball.interval().lower;
  }
  template <class Ball>
  static Ball in_square(const Ball& v) {
    return (v - Ball(1)).approximation() > 0 ? Ball(1) : v.approximation() < 0 ? Ball(0) : v;
  }

  /// True when the node is reached; otherwise the front is as far as these numbers lead.
  template <class Ball>
  bool follow(Front& front, double least) {
    StripPoint<Ball> at{rounded<Ball>(front.u), rounded<Ball>(front.v)};
    if (exact(at.u) != front.u || exact(at.v) != front.v) return false;
    const bool arrived =
        follow(PlaneStrip<Ball>(graph_.factors[graph_.arcs[arc_].factor]), at, front.reach, least);
    front.u = exact(at.u);
    front.v = exact(at.v);
    return arrived;
  }

  template <class Ball>
  bool follow(const PlaneStrip<Ball>& curve, StripPoint<Ball>& at, double& at_reach, double least) {
    const StripPoint<Ball> end{rounded<Ball>(node_[0].midpoint()), rounded<Ball>(node_[1].midpoint())};
    const double slack = place_slack(0, exact(end.u));
    const double direction = (end.u - at.u).approximation() > 0 ? 1 : -1;
    double step = 0x1p-8, share = 1;
    int failures = 0;  // since the last chord
    for (;;) {
      interruption_point();
      const double left = std::fabs((end.u - at.u).approximation());
      if (!(left > 4 * slack)) return false;
      if (step >= 0.75 * left) {
        if (advance(curve, at, at_reach, end, 1, slack)) return true;
        step = left / 2;
        share = std::min(share, 0.25);
      }
      if (step < least) return false;
      StripPoint<Ball> next{(at.u + Ball(direction * step)).midpoint(), at.v};
      const StripPoint<Ball> before = at;
      // Over a vertical tangent inside the arc v changes as a root of the step: the widest strip takes it.
      const bool wide = failures % 2 == 1 && step < widest_;
      const double tried = wide ? 1 : share;
      const std::optional<Ball> v =
          guess(curve, at, next.u, tried * widest_ / 16, wide || failures >= kPatience);
      if (v && (next.v = *v, advance(curve, at, at_reach, next, tried, 0))) {
        slope_ = (next.v - before.v).approximation() / (next.u - before.u).approximation();
        failures = 0;
        step = std::min(step * 1.25, kLongestStep);
        share = std::min(share * 1.6, 1.0);
      } else {
        const double less = failures++ == 0 ? 0.7 : 0.4;
        step *= less;
        share *= less;
      }
    }
  }

  /// About the v of the arc over u. Newton's method starts from the last chord; where it does not come to
  /// rest, as beside another arc, the arc is isolated if `isolate`.
  template <class Ball>
  std::optional<Ball> guess(const PlaneStrip<Ball>& curve, const StripPoint<Ball>& at, const Ball& u,
                            double rest, bool isolate) const {
    const double move = slope_ * (u - at.u).approximation();
    const std::optional<Ball> v = curve.zero_near(u, (at.v + Ball(move)).midpoint(), rest);
    if (v) return in_square(*v);
    if (!isolate) return std::nullopt;
    const std::optional<RationalInterval> found = arc_over(graph_, arc_, exact(u), from_double(rest));
    if (!found) return std::nullopt;
    return in_square(rounded<Ball>(found->midpoint()));
  }

  /// A bound of the distance of the node's coordinate from `middle`.
  double place_slack(std::size_t k, const Rational& middle) const {
    return to_double(std::max<Rational>(middle - node_[k].lower, node_[k].upper - middle)) * kSlack +
           kUnderflowLoss;
  }

  /// The chord from `at`, with the arc up to `at_reach` away, to `to`, if it is proved with this share of the
  /// widest strip; then `at` is there. Slack: of the node, which `to` stands for; 0 for other points.
  template <class Ball>
  bool advance(const PlaneStrip<Ball>& curve, StripPoint<Ball>& at, double& at_reach,
               const StripPoint<Ball>& to, double share, double slack) {
    const double du = (to.u - at.u).upper_magnitude(), dv = (to.v - at.v).upper_magnitude();
    use(rates_near(at.u.approximation(), to.u.approximation(), at.v.approximation(), to.v.approximation()));
    const double chord = chord_bound(rates_, du, dv) + rates_.u * slack;
    if (!(chord <= kChordShare * tolerance_)) return false;
    // Of a node only a place is known: a rise within it tells nothing about the arc.
    const double unsure = slack > 0 ? 2 * place_slack(1, exact(to.v)) : 0;
    const double rise = (to.v - at.v).lower_magnitude() > unsure ? (to.v - at.v).lower_magnitude() : 0;
    const double slope = rise / du * kReduced;
    const double width = std::min(share * widest_ * std::max(1.0, slope * steepness_), kWidestStrip);
    if (!(at_reach < std::min(width, widest_) / 8) && !narrow(curve, at, at_reach)) return false;
    const std::optional<double> off = curve.clear(at, to, width, slack);
    if (!off || !(at_reach + *off < width)) return false;
    double reach = (width + *off) * kSlack;
    double strip = rates_.v * reach;
    if (width > widest_) {
      std::optional<double> at_end =
          slack > 0 ? place_slack(1, exact(to.v)) : curve.distance_of_zero(to, reach);
      if (!at_end) at_end = exact_distance(exact(to.u), exact(to.v), widest_);
      if (!at_end || !(*at_end < widest_ / 8) || !(dv > 2 * (at_reach + *at_end))) return false;
      strip = rates_.u * reach / slope + rates_.v * larger_bound(at_reach, *at_end);
      reach = *at_end;
    }
    at = to;
    at_reach = reach;
    course_.vertices.push_back(vertex_at(at.u, at.v));
    last_ = {du, dv, strip + rates_.u * slack, rates_};
    course_.bound = larger_bound(course_.bound, strip + chord);
    return true;
  }

  /// A bound of the distance in v between the arc and a point, up to 2^-10 of `unit`.
  std::optional<double> exact_distance(const Rational& u, const Rational& v, double unit) const {
    const std::optional<RationalInterval> at =
        arc_over(graph_, arc_, u, from_double(unit) * power_of_two(-10));
    if (!at) return std::nullopt;
    return to_double(std::max<Rational>(abs(at->lower - v), abs(at->upper - v))) * kSlack + kUnderflowLoss;
  }

  /// Makes the reach small, by moving the point in v where it has to be.
  template <class Ball>
  bool narrow(const PlaneStrip<Ball>& curve, StripPoint<Ball>& at, double& reach) {
    if (const std::optional<Ball> v = curve.zero_near(at.u, at.v, reach * 0x1p-16)) {
      const StripPoint<Ball> moved{at.u, in_square(*v)};
      const double both = reach + (moved.v - at.v).upper_magnitude();
      const std::optional<double> distance = curve.distance_of_zero(moved, both);
      if (distance && *distance < reach / 2) {
        move(at, moved.v);
        reach = *distance;
        return true;
      }
    }
    const Rational fine = from_double(reach) * power_of_two(-30);
    const std::optional<RationalInterval> found = arc_over(graph_, arc_, exact(at.u), fine);
    if (!found) return false;
    move(at, in_square(rounded<Ball>(found->midpoint())));
    const Rational v = exact(at.v);
    const Rational off = std::max<Rational>(abs(found->lower - v), abs(found->upper - v));
    reach = to_double(off) * kSlack + kUnderflowLoss;
    return true;
  }

  template <class Ball>
  void move(StripPoint<Ball>& at, const Ball& v) {
    const double moved = (v - at.v).upper_magnitude();
    at.v = v;
    if (!course_.vertices.empty() && moved <= widest_ / 16) {  // the last chord turns a little
      course_.vertices.back() = vertex_at(at.u, at.v);
      last_.dv += moved * kSlack;
      last_.strip += last_.rates.v * moved * kSlack;
      course_.bound = larger_bound(course_.bound, last_.strip + chord_bound(last_.rates, last_.du, last_.dv));
    } else {
      course_.vertices.push_back(vertex_at(at.u, at.v));
    }
  }

  const CurveGraph& graph_;
  std::size_t arc_;
  const NodePlace& node_;
  const DrawnPatch& patch_;
  double tolerance_;
  PatchRates rates_;
  double widest_;
  double steepness_;  // D_v / D_u if the arc is monotone in v, else 0
  double slope_ = 0;  // of the last chord
  struct {
    double du, dv, strip;
    PatchRates rates;
  } last_{};  // chord
  HalfCourse course_;
};

/// A dyadic number of few bits in the widest of the arc's columns.
Rational inner_place(const CurveGraph& graph, const ArcColumns& columns) {
  Rational lower = 0, upper = 0;
  for (std::size_t i = columns.first; i <= columns.last; ++i) {
    const Rational a = graph.values[i].interval().upper, b = graph.values[i + 1].interval().lower;
    if (b - a > upper - lower) lower = a, upper = b;
  }
  for (long bits = 8;; bits *= 2) {
    const Rational units = (lower + upper) / 2 * power_of_two(bits);
    const Rational middle = Rational(Integer(numerator(units) / denominator(units))) * power_of_two(-bits);
    if (lower < middle && middle < upper) return middle;
  }
}

/// Vertices in doubles; the bound covers those of the chords in space and of the strips.
CurveCourse drawn(const std::vector<Vertex>& vertices, double bound, const DrawnPatch& patch) {
  CurveCourse course{};
  double error = 0;
  for (const auto& [u, v] : vertices) {
    const DrawnPoint point = patch.at(u, v);
    course.parameters.push_back({u.approximation(), v.approximation()});
    course.points.push_back(point.point);
    error = larger_bound(error, point.error);
  }
  course.error_bound = (bound + error) * kSlack;
  return course;
}

bool is_on_side(const TriangularPoint& inside) {
  const RationalInterval& v = inside.r_interval();
  return v.lower == v.upper && (v.lower == 0 || v.lower == 1);
}

}  // namespace

Rational place_width(const DrawnPatch& patch, double tolerance) {
  const double in_u = kChordShare * tolerance / patch.rates().u;
  const double in_v = strip_width(patch.rates(), tolerance);
  const double w = in_u < in_v ? in_u : in_v;
  if (!(in_u > 0 && in_v > 0))
    throw ProofFailure(whole_domain(), "the tolerance is below the range of doubles");
  return std::min<Rational>(power_of_two(-60), power_of_two(std::ilogb(w) - 12));
}

CurveCourse curve_course(const CurveGraph& graph, const std::vector<NodePlace>& places, std::size_t arc,
                         const DrawnPatch& patch, double tolerance) {
  const CurveBranch& branch = graph.arcs[arc];
  const NodePlace &from = places[branch.from], &to = places[branch.to];
  const std::optional<ArcColumns> columns = columns_of_arcs(graph)[arc];
  if (!columns || is_on_side(branch.inside)) return straight_course(from, to, patch, tolerance);
  const Rational u = inner_place(graph, *columns);
  const double fine = strip_width(patch.rates(), tolerance) * 0x1p-10;
  const RationalInterval at =
      *arc_over(graph, arc, u, std::min<Rational>(from_double(fine), power_of_two(-60)));
  const Rational v = from_double(to_double(at.midpoint()));
  const double reach =
      to_double(std::max<Rational>(abs(at.lower - v), abs(at.upper - v))) * kSlack + kUnderflowLoss;
  HalfCourse left = Follower(graph, arc, from, patch, tolerance).run({u, v, reach});
  const HalfCourse right = Follower(graph, arc, to, patch, tolerance).run({u, v, reach});
  std::vector<Vertex> vertices(left.vertices.rbegin(), left.vertices.rend());
  vertices.push_back(vertex_at(u, v));
  vertices.insert(vertices.end(), right.vertices.begin(), right.vertices.end());
  return drawn(vertices, larger_bound(left.bound, right.bound), patch);
}

CurveCourse straight_course(const NodePlace& from, const NodePlace& to, const DrawnPatch& patch,
                            double tolerance) {
  const Rational u0 = from[0].midpoint(), v0 = from[1].midpoint();
  const Rational du = to[0].midpoint() - u0, dv = to[1].midpoint() - v0;
  const double whole = chord_bound(patch.rates(), to_double(du), to_double(dv));
  const double wanted = std::ceil(std::sqrt(whole / (kChordShare * tolerance)));
  const int count = wanted < 100000 ? std::max(1, static_cast<int>(wanted)) : 100000;
  std::vector<Vertex> vertices;
  for (int i = 0; i <= count; ++i)
    vertices.push_back(
        vertex_at(Rational(u0 + du * Rational(i, count)), Rational(v0 + dv * Rational(i, count))));
  double slack = 0;
  for (const NodePlace& place : {from, to})
    slack = std::max(
        slack, patch.rates().u * to_double(place[0].width()) + patch.rates().v * to_double(place[1].width()));
  return drawn(vertices, whole / count / count + slack, patch);
}

}  // namespace exsect
