#include "side/shared_line_arcs.h"

#include <exsect/algebra/algebraic_value.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "answer/chord_count.h"
#include "answer/parameter_box.h"
#include "curve/plane_curve.h"
#include "line/line_point.h"
#include "line/system_point.h"

namespace exsect {

namespace {

std::vector<Rational> rational_roots(const Polynomial& f) {
  std::vector<Rational> roots;
  if (f.degree() <= 0) return roots;
  for (const PolynomialPower& power : irreducible_factors(f))
    if (power.factor.degree() == 1)
      roots.push_back(-power.factor.coefficient(0) / power.factor.coefficient(1));
  return roots;
}

BivariatePolynomial shifted(const BivariatePolynomial& f, const Rational& c) {
  return f - BivariatePolynomial::constant(c);
}

double upper_norm(const Point& p) { return length_bound(to_double(p[0]), to_double(p[1]), to_double(p[2])); }

using Parabola = std::array<Point, 3>;
using LineParameter = std::function<double(double)>;  // of tau in [0,1]

/// Where an event is on its line of the other patch.
struct Place {
  RealAlgebraic along;
  std::size_t end;
};

/// A double near the number, and a bound of its distance.
struct NearDouble {
  double value;
  double error;
};
NearDouble near(const RealAlgebraic& number) {
  const RationalInterval i = number.refined_to(power_of_two(-60)).interval();
  const double value = std::clamp(to_double(i.midpoint()), 0.0, 1.0);
  const Rational at = from_double(value);
  const Rational error = std::max<Rational>(abs(Rational(at - i.lower)), abs(Rational(i.upper - at)));
  return {value, to_double(error) * kSlack};
}

/// A polynomial on [0,1], in doubles. `error` bounds that of all values: each of the n coefficients c_i and
/// of the 2n - 2 operations of Horner's scheme errs by at most 2^-53 (1 + 2^-40) m, m the sum of all |c_i|.
class RoundedPolynomial {
 public:
  explicit RoundedPolynomial(const Polynomial& f) : end_(to_double(f(1))) {
    double sum = 0;
    for (int i = 0; i <= f.degree(); ++i) {
      coefficients_.push_back(to_double(f.coefficient(i)));
      sum += std::fabs(coefficients_.back());
    }
    error = static_cast<double>(coefficients_.size()) * sum * 0x1p-51 + kUnderflowLoss;
  }

  double operator()(double tau) const {
    if (tau == 1) return end_;
    double value = 0;
    for (std::size_t i = coefficients_.size(); i-- > 0;) value = value * tau + coefficients_[i];
    return value;
  }

  double error;

 private:
  std::vector<double> coefficients_;
  double end_;  // f(1) to the nearest double
};

class ArcsOnLine {
 public:
  /// On the line r = c (`fixes_first`) or s = c.
  ArcsOnLine(const LinePlace& place, const BezierPatch& patch, std::shared_ptr<const LineSystem> system,
             bool fixes_first, Rational c, const std::vector<CertifiedPoint>& ends, double tolerance)
      : place_(place),
        patch_(patch),
        system_(std::move(system)),
        fixes_first_(fixes_first),
        c_(std::move(c)),
        lambda_(fixes_first ? system_->lambda.at_r(c_) : system_->lambda.at_s(c_)),
        ends_(ends),
        tolerance_(tolerance) {}

  void run(const std::vector<LineEvent>& events, std::vector<LineArc>& arcs) const {
    for (std::size_t piece = 0; piece < system_->pieces.size(); ++piece) {
      const std::vector<Place> places = on_line(events, piece);
      const RationalInterval range = system_->pieces[piece].lambda;
      for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const Rational middle = rational_between(places[i].along, places[i + 1].along);
        const Rational lambda = lambda_(middle);
        if (lambda >= range.lower && lambda <= range.upper)
          arcs.push_back(arc(places[i], places[i + 1], middle, piece));
      }
    }
  }

 private:
  /// The events on the closed monotone piece, in their order along this line.
  std::vector<Place> on_line(const std::vector<LineEvent>& events, std::size_t piece) const {
    const BivariatePolynomial fixed = fixes_first_ ? BivariatePolynomial::r() : BivariatePolynomial::s();
    const BivariatePolynomial along = fixes_first_ ? BivariatePolynomial::s() : BivariatePolynomial::r();
    std::vector<Place> places;
    for (const LineEvent& event : events)
      if ((event.piece == piece || event.at_turn) && sign_at(shifted(fixed, c_), event.at) == 0)
        places.push_back({value_at(along, event.at), event.end});
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.along < b.along; });
    return places;
  }

  Point at(const Rational& along) const { return fixes_first_ ? patch_(c_, along) : patch_(along, c_); }

  LineArc arc(const Place& a, const Place& b, const Rational& middle, std::size_t piece) const {
    const Rational r = fixes_first_ ? c_ : middle;
    const Rational s = fixes_first_ ? middle : c_;
    const TriangularPoint inside(RealAlgebraic(s), shifted(BivariatePolynomial::r(), r), {r, r});
    const Rational before = rational_between(a.along, RealAlgebraic(middle));
    const RationalInterval& t = system_->pieces[piece].t;
    // Does lambda grow in the same direction along both lines?
    const bool alike = (lambda_(middle) > lambda_(before)) == (system_->phi(t.upper) > system_->phi(t.lower));
    const Place& from = alike ? a : b;
    const Place& to = alike ? b : a;
    const std::vector<std::size_t> pieces = pieces_at(*system_, inside);
    const auto which =
        static_cast<std::size_t>(std::find(pieces.begin(), pieces.end(), piece) - pieces.begin());
    LineArc result{
        from.end, to.end, system_points(place_, system_, inside, Polynomial(), initial_width()).at(which),
        {},       0,      {hull(ends_[from.end].box(), ends_[to.end].box())}};
    add_polyline(result, near(from.along), near(to.along), piece);
    // At a fold t is a square root, of which half the digits are lost.
    const std::size_t line = index(place_.roles.line);
    result.polyline.front().parameters[line] = approximation(ends_[from.end], line);
    result.polyline.back().parameters[line] = approximation(ends_[to.end], line);
    return result;
  }

  static double approximation(const CertifiedPoint& point, std::size_t k) {
    return to_double(point.refined_to(power_of_two(-60)).box()[k].midpoint());
  }

  /// Chords of a parabola with second derivative X'' over steps h keep within |X''| h²/8; its vertices are
  /// rounded, and those at the ends stand for points a little further on.
  void add_polyline(LineArc& arc, const NearDouble& from, const NearDouble& to, std::size_t piece) const {
    const Parabola line = parabola();
    const double second = 2 * upper_norm(line[2]);
    const double first = larger_bound(upper_norm(line[1]), upper_norm(line[1] + Rational(2) * line[2]));
    const double length = std::fabs(to.value - from.value) * kSlack;
    const double wanted = std::ceil(length * std::sqrt(second / (8 * 0.9 * tolerance_)));
    const int n = chord_count(wanted, fewest_chords());
    const double step = length / n + 0x1p-51;
    const Polynomial place({from_double(from.value), from_double(to.value) - from_double(from.value)});
    std::vector<RoundedPolynomial> coordinates;
    double rounding = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      coordinates.emplace_back(Polynomial({line[0][k], line[1][k], line[2][k]}).compose(place));
      rounding += coordinates.back().error;
    }
    const LineParameter t = line_parameter(place, piece);
    for (int i = 0; i <= n; ++i) {
      const double tau = static_cast<double>(i) / n;
      const double along = i == n ? to.value : from.value + (to.value - from.value) * tau;
      arc.polyline.push_back(vertex(along, t(tau)));
      for (std::size_t k = 0; k < 3; ++k) arc.polyline.back().point[k] = coordinates[k](tau);
    }
    arc.error_bound =
        (second * step * step / 8 + 2 * (rounding + first * larger_bound(from.error, to.error))) * kSlack;
  }

  /// The line of the other patch, by powers of the parameter along it.
  Parabola parabola() const {
    const Point start = at(0);
    const Point end = at(1);
    const Point second = Rational(2) * (start + end - Rational(2) * at(Rational(1, 2)));
    return {start, end - start - second, second};
  }

  /// Enough for t along a chord to be nearly linear in the parameter along this line: it may be a square, or
  /// a square root.
  double fewest_chords() const {
    if (system_->phi.degree() != 1) return 256;
    return lambda_.degree() > 1 ? 16 : 1;
  }

  PolylineVertex vertex(double along, double t) const {
    PolylineVertex result{};
    result.parameters[index(place_.roles.fixed)] = to_double(place_.value);
    result.parameters[index(place_.roles.line)] = std::clamp(t, 0.0, 1.0);
    result.parameters[index(place_.roles.first)] = fixes_first_ ? to_double(c_) : along;
    result.parameters[index(place_.roles.second)] = fixes_first_ ? along : to_double(c_);
    return result;
  }

  /// The t in the piece with phi(t) = lambda at a place along the other line, rounded.
  LineParameter line_parameter(const Polynomial& place, std::size_t piece) const {
    const Polynomial& phi = system_->phi;
    const Polynomial lambda = lambda_.compose(place);
    if (phi.degree() == 1)
      return RoundedPolynomial((lambda - Polynomial(phi.coefficient(0))) *
                               Polynomial(1 / phi.coefficient(1)));
    const Rational turn = -phi.coefficient(1) / 2;
    const double sign = turn <= system_->pieces[piece].t.lower ? 1 : -1;
    return [square = lambda + Polynomial(turn * turn), turn = to_double(turn), sign](double tau) {
      return turn + sign * std::sqrt(std::max(0.0, to_double(square(from_double(tau)))));
    };
  }

  const LinePlace& place_;
  const BezierPatch& patch_;
  std::shared_ptr<const LineSystem> system_;
  bool fixes_first_;
  Rational c_;
  Polynomial lambda_;
  const std::vector<CertifiedPoint>& ends_;
  double tolerance_;
};

}  // namespace

Rational rational_between(RealAlgebraic a, RealAlgebraic b) {
  for (Rational width = power_of_two(-8);; width *= width) {
    if (const Rational gap = b.interval().lower - a.interval().upper; gap > 0)
      return simplest_between(a.interval().upper + Rational(43, 100) * gap,
                              a.interval().upper + Rational(44, 100) * gap);
    a = a.refined_to(width);
    b = b.refined_to(width);
  }
}

LinesOfCurve rational_lines(const BivariatePolynomial& f) {
  LinesOfCurve result{{}, {}, f};
  const ContentAndPart in_s = split_content(f);
  const ContentAndPart in_r = split_content(in_s.primitive.exchanged());
  for (const Rational& c : rational_roots(in_s.content)) {
    result.second.push_back(c);
    result.rest = exact_quotient(result.rest, shifted(BivariatePolynomial::s(), c));
  }
  for (const Rational& c : rational_roots(in_r.content)) {
    result.first.push_back(c);
    result.rest = exact_quotient(result.rest, shifted(BivariatePolynomial::r(), c));
  }
  return result;
}

std::vector<LineArc> arcs_on_lines(const LinePlace& place, const BezierPatch& patch,
                                   const std::shared_ptr<const LineSystem>& system, const LinesOfCurve& lines,
                                   const std::vector<LineEvent>& events,
                                   const std::vector<CertifiedPoint>& ends, double tolerance) {
  std::vector<LineArc> arcs;
  for (const bool first : {true, false})
    for (const Rational& c : first ? lines.first : lines.second)
      if (c >= 0 && c <= 1) ArcsOnLine(place, patch, system, first, c, ends, tolerance).run(events, arcs);
  return arcs;
}

}  // namespace exsect
