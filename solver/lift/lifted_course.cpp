#include "lift/lifted_course.h"

#include <exsect/algebra/ball.h>
#include <exsect/algebra/interruption.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "curve/curve_place.h"
#include "curve/short_rational.h"
#include "curve/taylor_shift.h"

namespace exsect {
namespace {

constexpr int kDeepest = 400;

/// All values of a polynomial of degree at most 2 on a closed interval.
RationalInterval range_of(const Polynomial& f, const RationalInterval& on) {
  const Rational a = f(on.lower), b = f(on.upper);
  RationalInterval range{std::min(a, b), std::max(a, b)};
  if (const Rational bend = f.coefficient(2); bend != 0) {
    const Rational vertex = -f.coefficient(1) / (2 * bend);
    if (on.lower < vertex && vertex < on.upper) range = hull(range, {f(vertex), f(vertex)});
  }
  return range;
}

/// Not above, not below the root of q >= 0, next to it by 2^-bits.
RationalInterval root_of(const Rational& q, long bits) {
  const Rational scaled = q * power_of_two(2 * bits);
  const Integer below = sqrt(Integer(numerator(scaled) / denominator(scaled)));
  const Rational unit = power_of_two(-bits);
  return {Rational(below) * unit, Rational(below + 1) * unit};
}

/// y on a sheet, for the radicand in an interval that contains its true values, which are not negative.
RationalInterval on_sheet(const RationalInterval& radicand, int sheet) {
  if (sheet == 0) return {0, 0};
  const Rational lower = std::max<Rational>(radicand.lower, 0), upper = std::max<Rational>(radicand.upper, 0);
  const RationalInterval roots = {root_of(lower, 100).lower, root_of(upper, 100).upper};
  return sheet > 0 ? roots : RationalInterval{-roots.upper, -roots.lower};
}

/// Radicands have no product of u and v.
class Radicand {
 public:
  explicit Radicand(const BivariatePolynomial& y2)
      : in_u_(y2.at_s(0)), in_v_(y2.at_r(0) - Polynomial(y2.coefficient(0, 0))) {}

  RationalInterval on(const RationalInterval& u, const RationalInterval& v) const {
    const RationalInterval a = range_of(in_u_, u), b = range_of(in_v_, v);
    return {a.lower + b.lower, a.upper + b.upper};
  }

 private:
  Polynomial in_u_;
  Polynomial in_v_;
};

/// A polynomial in balls, divided by its greatest coefficient; all values on a rectangle.
class EnclosedPolynomial {
 public:
  EnclosedPolynomial(const BivariatePolynomial& f, const Rational& unit)
      : row_(static_cast<std::size_t>(std::max(f.degree_s(), 0)) + 1),
        c_(enclosed_coefficients<DoubleBall>(f, unit)) {}

  /// For |u - at_u| <= du, |v - at_v| <= dv: Taylor's expansion about the middle.
  DoubleBall on(double at_u, double at_v, double du, double dv) const {
    std::vector<DoubleBall> c = c_;
    shift_to(c, row_, DoubleBall(at_u), DoubleBall(at_v));
    double others = 0, power_u = 1;
    for (std::size_t i = 0; i < c.size(); i += row_, power_u *= du) {
      double power = power_u;
      for (std::size_t j = 0; j < row_; ++j, power *= dv)
        if (i + j > 0) others += c[i + j].upper_magnitude() * power;
    }
    return c[0].widened(others * kSlack + kUnderflowLoss);
  }

 private:
  std::size_t row_;
  std::vector<DoubleBall> c_;
};

/// t = (2 y g_v, -2 y g_u, Y_u g_v - Y_v g_u) (17.6) for g = 0 and y^2 = Y; without y on the plane of
/// symmetry. On a torus its image in space.
class Tangents {
 public:
  Tangents(const BivariatePolynomial& g, const SurfaceChart& chart, bool is_planar)
      : is_planar_(is_planar),
        chart_(chart),
        height_rate_(rate(chart.height, chart.denominator)),
        width_rate_(rate(chart.width, chart.denominator)),
        g_u_(g.derivative_r(), greatest_coefficient(g)),
        g_v_(g.derivative_s(), greatest_coefficient(g)),
        y2_u_(chart.radicand.derivative_r(), 1),
        y2_v_(chart.radicand.derivative_s(), 1) {}

  std::array<DoubleBall, 3> on(const RationalInterval& u, const RationalInterval& v,
                               const RationalInterval& y) const {
    const double at_u = to_double(u.midpoint()), at_v = to_double(v.midpoint());
    const double du = reach(u, at_u), dv = reach(v, at_v);
    const DoubleBall a = g_u_.on(at_u, at_v, du, dv), b = g_v_.on(at_u, at_v, du, dv);
    if (is_planar_) return in_space({b, -a, DoubleBall(0)}, u, v, y);
    const DoubleBall y2_u = y2_u_.on(at_u, at_v, du, dv), y2_v = y2_v_.on(at_u, at_v, du, dv);
    const DoubleBall twice = DoubleBall(2) * DoubleBall::enclosing(y);
    return in_space({twice * b, -(twice * a), y2_u * b - y2_v * a}, u, v, y);
  }

 private:
  /// The numerator of the derivative of a quotient.
  static Polynomial rate(const Polynomial& above, const Polynomial& below) {
    return above.derivative() * below - above * below.derivative();
  }

  /// (17.14), of H and W by their numerators and the denominator.
  std::array<DoubleBall, 3> in_space(const std::array<DoubleBall, 3>& t, const RationalInterval& u,
                                     const RationalInterval& v, const RationalInterval& y) const {
    if (chart_.is_affine()) return t;
    const RationalInterval below = range_of(chart_.denominator, u);
    const auto over = [&](const RationalInterval& above) {
      return DoubleBall::enclosing(quotients(above, below));
    };
    const DoubleBall once = over(RationalInterval{1, 1}), width = over(range_of(chart_.width, u)),
                     du = t[0] * once * once, dw = DoubleBall::enclosing(range_of(width_rate_, u)) * du;
    return {
        DoubleBall::enclosing(range_of(height_rate_, u)) * du,
        width * t[1] +
            DoubleBall::enclosing(RationalInterval{v.lower - chart_.middle, v.upper - chart_.middle}) * dw,
        width * t[2] + DoubleBall::enclosing(y) * dw};
  }

  static double reach(const RationalInterval& on, double middle) {
    const Rational m = from_double(middle);
    return to_double(std::max<Rational>(m - on.lower, on.upper - m)) * kSlack + kUnderflowLoss;
  }

  bool is_planar_;
  const SurfaceChart& chart_;
  Polynomial height_rate_, width_rate_;
  EnclosedPolynomial g_u_, g_v_, y2_u_, y2_v_;
};

using Interval3 = std::array<RationalInterval, 3>;  // of u, v, y

RationalInterval products(const RationalInterval& a, const RationalInterval& b) {
  const auto [least, most] = std::minmax({Rational(a.lower * b.lower), Rational(a.lower * b.upper),
                                          Rational(a.upper * b.lower), Rational(a.upper * b.upper)});
  return {least, most};
}

/// The multiples of the chart's three vectors, from its origin, of points with u, v, y in these intervals.
Interval3 along_axes(const SurfaceChart& chart, const Interval3& at) {
  if (chart.is_affine()) return at;
  const RationalInterval below = range_of(chart.denominator, at[0]);
  const RationalInterval width = quotients(range_of(chart.width, at[0]), below);
  return {quotients(range_of(chart.height, at[0]), below),
          products(width, {at[1].lower - chart.middle, at[1].upper - chart.middle}), products(width, at[2])};
}

/// For multiples of the chart's three vectors.
SpaceBox in_space(const SurfaceChart& chart, const Interval3& at) {
  SpaceBox box;
  const std::array<const Point*, 3> along = {&chart.along_u, &chart.along_v, &chart.along_y};
  for (std::size_t k = 0; k < 3; ++k) {
    box[k] = {chart.origin[k], chart.origin[k]};
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational& rate = (*along[i])[k];
      const Rational a = rate * at[i].lower, b = rate * at[i].upper;
      box[k].lower += std::min(a, b);
      box[k].upper += std::max(a, b);
    }
  }
  return box;
}

/// A point of the arc.
struct Vertex {
  Interval3 at;
  std::array<double, 3> point;   // of space
  std::array<double, 3> scaled;  // about the multiples of the chart's vectors, times their lengths
  double error;                  // of point
};

/// Cuts one arc until every chord is proved.
class Course {
 public:
  Course(const LiftedCurve& curve, std::size_t arc, double tolerance)
      : curve_(curve),
        arc_(curve.arcs[arc]),
        branch_(curve.below.arcs[arc_.below]),
        radicand_(curve.chart.radicand),
        tangents_(curve.factors[arc_.factor].factor, curve.chart, arc_.sheet == 0),
        tolerance_(tolerance) {
    const SurfaceChart& chart = curve.chart;
    const std::array<const Point*, 3> along = {&chart.along_u, &chart.along_v, &chart.along_y};
    for (std::size_t k = 0; k < 3; ++k) lengths_[k] = std::sqrt(to_double(dot(*along[k], *along[k])));
    is_vertical_ = curve.below.nodes[branch_.from].u == curve.below.nodes[branch_.to].u;
  }

  SpaceCourse run() {
    const Vertex from = end(arc_.from), to = end(arc_.to);
    course_.points = {from.point};
    cut(from, to, 0);
    course_.error_bound *= kSlack;
    return std::move(course_);
  }

 private:
  Vertex vertex(const RationalInterval& u, const RationalInterval& v, int sheet) const {
    Vertex result{{u, v, on_sheet(radicand_.on(u, v), sheet)}, {}, {}, 0};
    const Interval3 along = along_axes(curve_.chart, result.at);
    const SpaceBox box = in_space(curve_.chart, along);
    std::array<double, 3> off{};
    for (std::size_t k = 0; k < 3; ++k) {
      result.point[k] = to_double(box[k].midpoint());
      const Rational at = from_double(result.point[k]);
      off[k] = to_double(std::max<Rational>(box[k].upper - at, at - box[k].lower));
      result.scaled[k] = to_double(along[k].midpoint()) * lengths_[k];
    }
    result.error = length_bound(off[0], off[1], off[2]) * kSlack + kUnderflowLoss;
    return result;
  }

  Vertex end(std::size_t node) const {
    const LiftedNode& at = curve_.nodes[node];
    const auto [u, v] = place_of(curve_.below, at.below, power_of_two(-80));
    return vertex(u, v, at.sheet);
  }

  void cut(const Vertex& a, const Vertex& b, int depth) {
    interruption_point();
    if (const std::optional<double> bound = proved_bound(a, b)) {
      course_.points.push_back(b.point);
      course_.error_bound = larger_bound(course_.error_bound, *bound);
      return;
    }
    if (depth > kDeepest) throw ProofFailure(whole_domain(), "an arc in space cannot be drawn");
    const Vertex middle = is_vertical_ ? on_line(a, b) : between(a, b);
    cut(a, middle, depth + 1);
    cut(middle, b, depth + 1);
  }

  /// Between two points of a line u = const.
  Vertex on_line(const Vertex& a, const Vertex& b) const {
    const RationalInterval& u = a.at[0].width() < b.at[0].width() ? a.at[0] : b.at[0];
    const Rational v = middle_of(a.at[1], b.at[1]);
    return vertex(u, {v, v}, arc_.sheet);
  }

  /// Over a rational u between those of two points; v is the only zero between theirs, or isolated exactly.
  Vertex between(const Vertex& a, const Vertex& b) const {
    const Rational u = middle_of(a.at[0], b.at[0]);
    const Polynomial over = curve_.below.swept.at_r(u);
    const RationalInterval range = hull(a.at[1], b.at[1]);
    const std::vector<RealAlgebraic> zeros = real_roots(over, range.lower, range.upper);
    if (zeros.size() == 1) return vertex({u, u}, zeros[0].refined_to(kFine).interval(), arc_.sheet);
    for (Rational at = u;; at = (at + b.at[0].lower) / 2) {
      interruption_point();
      if (const auto v = arc_over(curve_.below, arc_.below, at, kFine))
        return vertex({at, at}, *v, arc_.sheet);
    }
  }

  /// A number of few bits between two closed intervals, about in the middle.
  static Rational middle_of(const RationalInterval& a, const RationalInterval& b) {
    const bool up = a.upper < b.lower;
    const Rational lower = up ? a.upper : b.upper, upper = up ? b.lower : a.lower;
    if (!(lower < upper)) throw ProofFailure(whole_domain(), "nodes of an arc in space are not apart");
    const Rational third = (upper - lower) / 3;
    return simplest_between(lower + third, upper - third);
  }

  /// The arc from a to b is monotone in u and v. A bound of the distance to the chord that is small enough.
  std::optional<double> proved_bound(const Vertex& a, const Vertex& b) const {
    const RationalInterval u = hull(a.at[0], b.at[0]), v = hull(a.at[1], b.at[1]);
    const RationalInterval y = on_sheet(radicand_.on(u, v), arc_.sheet);
    const Interval3 along = along_axes(curve_.chart, {u, v, y});
    const double size =
        length_bound(to_double(along[0].width()) * lengths_[0], to_double(along[1].width()) * lengths_[1],
                     to_double(along[2].width()) * lengths_[2]) *
        kSlack;
    const double error = larger_bound(a.error, b.error), wanted = larger_bound(tolerance_, 4 * error);
    if (!std::isfinite(wanted))
      throw ProofFailure(whole_domain(), "an arc in space is not in the range of doubles");
    if (size + error <= wanted) return (size + error) * kSlack;
    const std::optional<double> slope = slope_to_chord(a, b, tangents_.on(u, v, y));
    if (!slope) return std::nullopt;
    const double bound = *slope * (length(a, b) + 2 * error) / 2 * kSlack + 3 * error;
    return bound <= wanted ? std::optional(bound) : std::nullopt;
  }

  /// Not below the chord's length. Of `scaled`, a rounded quotient times a rounded length, 2^-50 is lost.
  static double length(const Vertex& a, const Vertex& b) {
    double rounding = kUnderflowLoss;
    for (std::size_t k = 0; k < 3; ++k)
      rounding += (std::fabs(a.scaled[k]) + std::fabs(b.scaled[k])) * 0x1p-50;
    return length_bound(b.scaled[0] - a.scaled[0], b.scaled[1] - a.scaled[1], b.scaled[2] - a.scaled[2]) +
           rounding * kSlack;
  }

  /// A bound of |t x d| / |t . d| for the direction d of the chord and all tangents.
  std::optional<double> slope_to_chord(const Vertex& a, const Vertex& b,
                                       const std::array<DoubleBall, 3>& tangents) const {
    std::array<DoubleBall, 3> t, d;
    for (std::size_t k = 0; k < 3; ++k) {
      t[k] = tangents[k] * DoubleBall(lengths_[k]);
      d[k] = DoubleBall(b.scaled[k] - a.scaled[k]);
    }
    const double along = (t[0] * d[0] + t[1] * d[1] + t[2] * d[2]).lower_magnitude();
    if (!(along > 0)) return std::nullopt;
    const auto minor = [&](std::size_t i, std::size_t j) {
      return (t[i] * d[j] - t[j] * d[i]).upper_magnitude();
    };
    return length_bound(minor(0, 1), minor(1, 2), minor(2, 0)) / along * kSlack;
  }

  static inline const Rational kFine = power_of_two(-80);

  const LiftedCurve& curve_;
  const LiftedArc& arc_;
  const CurveBranch& branch_;
  Radicand radicand_;
  Tangents tangents_;
  double tolerance_;
  std::array<double, 3> lengths_{};
  bool is_vertical_;
  SpaceCourse course_{{}, 0};
};

}  // namespace

SpaceBox place_in_space(const LiftedCurve& curve, std::size_t node, const Rational& width) {
  const LiftedNode& at = curve.nodes[node];
  const auto [u, v] = place_of(curve.below, at.below, width);
  const RationalInterval y = on_sheet(Radicand(curve.chart.radicand).on(u, v), at.sheet);
  return in_space(curve.chart, along_axes(curve.chart, {u, v, y}));
}

double extent_of(const SurfaceChart& chart) {
  return std::sqrt(
      to_double(std::max<Rational>(dot(chart.along_u, chart.along_u), dot(chart.along_v, chart.along_v))));
}

SpaceCourse course_in_space(const LiftedCurve& curve, std::size_t arc, double tolerance) {
  return Course(curve, arc, tolerance).run();
}

}  // namespace exsect
