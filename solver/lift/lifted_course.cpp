#include "lift/lifted_course.h"

#include <exsect/algebra/interruption.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "curve/curve_place.h"
#include "lift/ball_chart.h"
#include "lift/chart_tangents.h"
#include "lift/middle_places.h"

namespace exsect {
namespace {

/// Cuts one arc until every chord is proved.
template <class Chart>
class Course {
  using Interval = typename Chart::Interval;
  using Place = typename Chart::Place;
  using BallPlace = BallChart::Place;

  /// A point of the arc.
  struct Vertex {
    Place at;                      // u, v, y
    std::array<double, 3> point;   // of space
    std::array<double, 3> scaled;  // about the multiples of the chart's vectors, times their lengths
    double error;                  // of point
  };
  /// A vertex that is still to be reached, and how often the way to it was cut.
  struct Target {
    Vertex vertex;
    int cuts;
  };

 public:
  explicit Course(const DrawnArc& arc)
      : arc_(arc),
        chart_(arc.curve.chart),
        balls_(arc.curve.chart),
        tangents_(arc.curve.factors[arc.lifted().factor].factor, arc.curve.chart, arc.lifted().sheet == 0),
        middles_(arc),
        is_vertical_(arc.is_vertical()) {
    const SurfaceChart& chart = arc.curve.chart;
    const std::array<const Point*, 3> along = {&chart.along_u, &chart.along_v, &chart.along_y};
    for (std::size_t k = 0; k < 3; ++k) lengths_[k] = std::sqrt(to_double(dot(*along[k], *along[k])));
  }

  /// Empty where these numbers do not lead to the tolerance.
  std::optional<SpaceCourse> run() {
    const Vertex from = end(arc_.lifted().from), to = end(arc_.lifted().to);
    course_.points = {from.point};
    if (!is_fine(from) || !is_fine(to) || !draw(from, to)) return std::nullopt;
    course_.error_bound *= kSlack;
    return std::move(course_);
  }

 private:
  static constexpr bool kExact = std::is_same_v<Interval, RationalInterval>;
  /// Cuts on the way to a vertex. Doubles are given up sooner.
  static constexpr int kMostCuts = kExact ? 400 : 60;
  /// What is longer than so many chords is halved; otherwise the next vertex is one chord away.
  static constexpr double kFewChords = 8;
  /// What is longer than so many chords is not tried as one; the bound of a chord is to be this part of what
  /// is wanted.
  static constexpr double kTriedChords = 1.05;
  static constexpr double kAimed = 0.9;
  /// Bounds are about proportional to the squares of lengths below this slope.
  static constexpr double kGentleSlope = 0.25;

  Vertex vertex(const Interval& u, const Interval& v, int sheet) const {
    Vertex result{{u, v, chart_.y_over(u, v, sheet)}, {}, {}, 0};
    const Place along = chart_.along_axes(result.at);
    const auto place = chart_.in_space(along);
    std::array<double, 3> off{};
    for (std::size_t k = 0; k < 3; ++k) {
      result.point[k] = middle_of(place[k]);
      off[k] = distance_from(place[k], result.point[k]);
      result.scaled[k] = middle_of(along[k]) * lengths_[k];
    }
    result.error = length_bound(off[0], off[1], off[2]) * kSlack + kUnderflowLoss;
    return result;
  }

  Vertex end(std::size_t node) const {
    const LiftedNode& at = arc_.curve.nodes[node];
    const auto [u, v] = place_of(arc_.curve.below, at.below, fine_width());
    if constexpr (kExact)
      return vertex(u, v, at.sheet);
    else
      return vertex(DoubleBall::enclosing(u), DoubleBall::enclosing(v), at.sheet);
  }

  /// Of doubles no more than a part of the tolerance may be lost.
  bool is_fine(const Vertex& a) const { return kExact || a.error <= arc_.tolerance / 16; }

  /// False where these numbers do not lead to the tolerance.
  bool draw(Vertex at, const Vertex& to) {
    std::vector<Target> targets = {{to, 0}};
    while (!targets.empty()) {
      interruption_point();
      const Vertex& next = targets.back().vertex;
      if (!(expected_chords(at, next) > kTriedChords) && try_chord(at, next)) {
        at = next;
        targets.pop_back();
        continue;
      }
      const int cuts = ++targets.back().cuts;
      if (cuts > kMostCuts) {
        if constexpr (kExact) throw ProofFailure(whole_domain(), "an arc in space cannot be drawn");
        return false;
      }
      const std::optional<Vertex> middle = is_vertical_ ? on_line(at, next) : between(at, next);
      if (!middle || !is_fine(*middle)) return false;
      targets.push_back({*middle, cuts});
    }
    return true;
  }

  /// Between two points of a line u = const.
  std::optional<Vertex> on_line(const Vertex& a, const Vertex& b) const {
    const Interval& u = width_of(a.at[0]) < width_of(b.at[0]) ? a.at[0] : b.at[0];
    const std::optional<Interval> v = middles_.between(a.at[1], b.at[1], share(a, b));
    if (!v) return std::nullopt;
    return vertex(u, *v, arc_.lifted().sheet);
  }

  /// Beside a v between those of two points, where that is one point.
  std::optional<Vertex> beside(const Vertex& a, const Vertex& b) const requires(!kExact) {
    const std::optional<Interval> v = middles_.between(a.at[1], b.at[1], share(a, b));
    return v ? on_arc(middles_.beside(*v, hull(a.at[0], b.at[0]))) : std::nullopt;
  }

  /// Over a u between those of two points. An arc that is steep there is monotone in v as well: its zero over
  /// u is known less well than that beside v.
  std::optional<Vertex> between(const Vertex& a, const Vertex& b) const {
    if constexpr (!kExact) {
      if (is_steep(a, b)) {
        const std::optional<Vertex> found = beside(a, b);
        if (found && is_fine(*found)) return found;
      }
    }
    const std::optional<Interval> u = middles_.between(a.at[0], b.at[0], share(a, b));
    if (!u) return std::nullopt;
    const Interval range = hull(a.at[1], b.at[1]);
    if constexpr (kExact) {
      return on_arc(middles_.on_arc(*u, range, b.at[0]));
    } else {
      const std::optional<Vertex> quick = on_arc(middles_.on_arc(*u, range));
      return quick && is_fine(*quick) ? quick : on_arc(middles_.nearest_on_arc(*u, range));
    }
  }
  static bool is_steep(const Vertex& a, const Vertex& b) {
    return std::fabs(b.scaled[1] - a.scaled[1]) > std::fabs(b.scaled[0] - a.scaled[0]);
  }
  std::optional<Vertex> on_arc(const std::optional<std::array<Interval, 2>>& at) const {
    if (!at) return std::nullopt;
    return vertex((*at)[0], (*at)[1], arc_.lifted().sheet);
  }

  /// How many chords lead from a to b, if they are as long as the last one tried tells.
  double expected_chords(const Vertex& a, const Vertex& b) const { return chords_per_length_ * length(a, b); }

  /// Where the next vertex is looked for. y is about a root of the distance from a place with y = 0: a
  /// quarter halves it.
  double share(const Vertex& a, const Vertex& b) const {
    const double chords = expected_chords(a, b);
    const double step = chords > 2 && chords <= kFewChords ? 1 / std::ceil(chords) : 0.5;
    const bool from_fold = middle_of(a.at[2]) == 0, to_fold = middle_of(b.at[2]) == 0;
    return from_fold == to_fold ? step : from_fold ? step * step : step * (2 - step);
  }

  /// The arc from a to b is monotone in u and v. The chord is drawn if a bound of its distance is small
  /// enough.
  bool try_chord(const Vertex& a, const Vertex& b) {
    const Interval u = hull(a.at[0], b.at[0]), v = hull(a.at[1], b.at[1]);
    const Place at = {u, v, chart_.y_over(u, v, arc_.lifted().sheet)};
    const double error = larger_bound(a.error, b.error), wanted = larger_bound(arc_.tolerance, 4 * error);
    if (kExact && !std::isfinite(wanted))
      throw ProofFailure(whole_domain(), "an arc in space is not in the range of doubles");
    chords_per_length_ = 0;
    if (append_if_small(b, size_of(chart_.along_axes(at)) + error, wanted)) return true;
    BallPlace balls = {ball_of(u), ball_of(v), ball_of(at[2])};
    const ChartRates rates = tangents_.rates(balls[0], balls[1], middle_of(b.at[0]) - middle_of(a.at[0]),
                                             middle_of(b.at[1]) - middle_of(a.at[1]));
    if (narrow_y(balls, a, b, rates) && append_if_small(b, size_of(balls_.along_axes(balls)) + error, wanted))
      return true;
    const double slope = slope_to_chord(a, b, tangents_.over(rates, balls, balls_));
    const double reach = length(a, b), bent = slope * (reach + 2 * error) / 2 * kSlack;
    const double bound = bent + 3 * error, chords = std::sqrt(bent / (kAimed * wanted - 3 * error));
    if (slope <= kGentleSlope) chords_per_length_ = chords / reach;
    return bound <= wanted && append(b, bound);
  }

  /// y along the arc from a to b by (17.6b), where that is narrower than on the rectangle: beside the
  /// silhouette, where the rectangle says less than that y goes no further than the chord.
  bool narrow_y(BallPlace& at, const Vertex& a, const Vertex& b, const ChartRates& rates) const {
    if (arc_.lifted().sheet == 0 || is_vertical_ || at[2].radius() * lengths_[2] <= length(a, b))
      return false;
    const auto square = [&](const Vertex& end) {
      return balls_.square_over(ball_of(end.at[0]), ball_of(end.at[1]));
    };
    const DoubleBall y = BallChart::y_of(
        squares_between(square(a), square(b), rates, width_of(at[0]), width_of(at[1])), arc_.lifted().sheet);
    if (!(y.radius() < at[2].radius())) return false;
    at[2] = y;
    return true;
  }

  /// A bound of the diameter of a box along the axes.
  template <class Number>
  double size_of(const std::array<Number, 3>& along) const {
    return length_bound(width_of(along[0]) * lengths_[0], width_of(along[1]) * lengths_[1],
                        width_of(along[2]) * lengths_[2]) *
           kSlack;
  }

  bool append_if_small(const Vertex& b, double bound, double wanted) {
    return bound <= wanted && append(b, bound * kSlack);
  }

  bool append(const Vertex& b, double bound) {
    course_.points.push_back(b.point);
    course_.error_bound = larger_bound(course_.error_bound, bound);
    return true;
  }

  /// Not below the chord's length. Of `scaled`, a rounded quotient times a rounded length, 2^-50 is lost.
  static double length(const Vertex& a, const Vertex& b) {
    double rounding = kUnderflowLoss;
    for (std::size_t k = 0; k < 3; ++k)
      rounding += (std::fabs(a.scaled[k]) + std::fabs(b.scaled[k])) * 0x1p-50;
    return length_bound(b.scaled[0] - a.scaled[0], b.scaled[1] - a.scaled[1], b.scaled[2] - a.scaled[2]) +
           rounding * kSlack;
  }

  /// A bound of |t x d| / |t . d| for the direction d of the chord and all tangents; infinite if not known.
  double slope_to_chord(const Vertex& a, const Vertex& b, const std::array<DoubleBall, 3>& tangents) const {
    std::array<DoubleBall, 3> t, d;
    for (std::size_t k = 0; k < 3; ++k) {
      t[k] = tangents[k] * DoubleBall(lengths_[k]);
      d[k] = DoubleBall(b.scaled[k] - a.scaled[k]);
    }
    const double along = (t[0] * d[0] + t[1] * d[1] + t[2] * d[2]).lower_magnitude();
    if (!(along > 0)) return std::numeric_limits<double>::infinity();
    const auto minor = [&](std::size_t i, std::size_t j) {
      return (t[i] * d[j] - t[j] * d[i]).upper_magnitude();
    };
    return length_bound(minor(0, 1), minor(1, 2), minor(2, 0)) / along * kSlack;
  }

  const DrawnArc& arc_;
  Chart chart_;
  BallChart balls_;
  ChartTangents tangents_;
  MiddlePlaces<Interval> middles_;
  bool is_vertical_;
  std::array<double, 3> lengths_{};
  double chords_per_length_ = 0;  // 0: not known
  SpaceCourse course_{{}, 0};
};

}  // namespace

SpaceBox place_in_space(const LiftedCurve& curve, std::size_t node, const Rational& width) {
  const LiftedNode& at = curve.nodes[node];
  const auto [u, v] = place_of(curve.below, at.below, width);
  const ExactChart chart(curve.chart);
  return chart.in_space(chart.along_axes({u, v, chart.y_over(u, v, at.sheet)}));
}

double extent_of(const SurfaceChart& chart) {
  return std::sqrt(
      to_double(std::max<Rational>(dot(chart.along_u, chart.along_u), dot(chart.along_v, chart.along_v))));
}

SpaceCourse course_in_space(const LiftedCurve& curve, std::size_t arc, double tolerance) {
  const DrawnArc drawn{curve, arc, tolerance};
  if (std::optional<SpaceCourse> course = Course<BallChart>(drawn).run()) return std::move(*course);
  return *Course<ExactChart>(drawn).run();
}

}  // namespace exsect
