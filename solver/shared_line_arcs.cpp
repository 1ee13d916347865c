#include "shared_line_arcs.h"

#include <exsect/algebra/algebraic_value.h>

#include <algorithm>
#include <cmath>

#include "line_point.h"
#include "parameter_box.h"
#include "plane_curve.h"

namespace exsect {

namespace {

constexpr double kMostChords = 1e6;

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

double upper_norm(const Point& p) {
  return std::hypot(to_double(p[0]), to_double(p[1]), to_double(p[2])) * (1 + 0x1p-40);
}

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
  return {value, to_double(error) * (1 + 0x1p-50)};
}

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
  Point slope(const Rational& along) const {
    return fixes_first_ ? patch_.derivative_second(c_, along) : patch_.derivative_first(along, c_);
  }

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
    return result;
  }

  /// Chords of a parabola with second derivative X'' over steps h keep within |X''| h²/8; its vertices are
  /// rounded, and those at the ends stand for points a little further on.
  void add_polyline(LineArc& arc, const NearDouble& from, const NearDouble& to, std::size_t piece) const {
    const double second = upper_norm(Rational(4) * (at(0) + at(1) - Rational(2) * at(Rational(1, 2))));
    const double first = std::max(upper_norm(slope(0)), upper_norm(slope(1)));
    const double length = std::fabs(to.value - from.value) * (1 + 0x1p-40);
    const double wanted = std::ceil(length * std::sqrt(second / (8 * 0.9 * tolerance_)));
    const int n = static_cast<int>(std::clamp(wanted, fewest_chords(), kMostChords));
    const double step = length / n + 0x1p-51;
    double rounding = 0;
    for (int i = 0; i <= n; ++i) {
      const double along =
          i == n ? to.value : from.value + (to.value - from.value) * (static_cast<double>(i) / n);
      arc.polyline.push_back(vertex(from_double(along), piece, rounding));
    }
    arc.error_bound =
        (second * step * step / 8 + 2 * (rounding + first * std::max(from.error, to.error))) * (1 + 0x1p-40);
  }

  /// Enough for t along a chord to be nearly linear in the parameter along this line: it may be a square, or
  /// a square root.
  double fewest_chords() const {
    if (system_->phi.degree() != 1) return 256;
    return lambda_.degree() > 1 ? 16 : 1;
  }

  PolylineVertex vertex(const Rational& along, std::size_t piece, double& rounding) const {
    const Point p = at(along);
    PolylineVertex result{};
    double error = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      result.point[k] = to_double(p[k]);
      error += std::fabs(result.point[k]) * 0x1p-52;
    }
    rounding = std::max(rounding, error);
    result.parameters[index(place_.roles.fixed)] = to_double(place_.value);
    result.parameters[index(place_.roles.line)] = std::clamp(parameter(lambda_(along), piece), 0.0, 1.0);
    result.parameters[index(place_.roles.first)] = to_double(fixes_first_ ? c_ : along);
    result.parameters[index(place_.roles.second)] = to_double(fixes_first_ ? along : c_);
    return result;
  }

  /// The t in the piece with phi(t) = lambda, rounded.
  double parameter(const Rational& lambda, std::size_t piece) const {
    const Polynomial& phi = system_->phi;
    if (phi.degree() == 1) return to_double((lambda - phi.coefficient(0)) / phi.coefficient(1));
    const Rational turn = -phi.coefficient(1) / 2;
    const double root = std::sqrt(std::max(0.0, to_double(turn * turn + lambda)));
    return to_double(turn) + (turn <= system_->pieces[piece].t.lower ? root : -root);
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
