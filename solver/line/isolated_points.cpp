#include "line/isolated_points.h"

#include <exsect/algebra/resultant.h>

#include <algorithm>
#include <array>

#include "curve/plane_curve.h"

namespace exsect {
namespace {

struct LocalCurve {
  Polynomial content;     // the lines s = const of the curve
  BivariatePolynomial f;  // the rest of it
  CurvePart part;
  std::vector<Polynomial> events;  // along a branch of f, membership in S changes only over their roots
};

BivariatePolynomial shifted(const BivariatePolynomial& f, const Rational& c) {
  return f - BivariatePolynomial::constant(c);
}

/// f without the components on which h vanishes identically.
BivariatePolynomial without(const BivariatePolynomial& f, const BivariatePolynomial& h) {
  return h.is_zero() ? BivariatePolynomial::constant(1) : exact_quotient(f, gcd(f, h));
}

LocalCurve local_curve(const BivariatePolynomial& curve, const CurvePart& part) {
  const ContentAndPart parts = split_content(curve);
  const Polynomial s = Polynomial::variable();
  LocalCurve c{parts.content, parts.primitive, part, {s * (s - Polynomial(1))}};
  std::vector<Polynomial> candidates = {c.content};
  for (const int side : {0, 1}) {
    const BivariatePolynomial edge = shifted(BivariatePolynomial::r(), side);
    candidates.push_back(without(c.f, edge).at_r(side));
  }
  for (const BivariatePolynomial& border : part.borders)
    if (!border.is_zero()) candidates.push_back(resultant_r(without(c.f, border), border));
  if (c.f.degree_r() > 1) candidates.push_back(discriminant_r(c.f));
  for (const Polynomial& candidate : candidates)
    if (candidate.degree() > 0) c.events.push_back(candidate);
  return c;
}

/// Whose roots r over s lie at branches of f and, if the line through s belongs to the curve, at the r where
/// its membership in S may change.
BivariatePolynomial events_over(const LocalCurve& c, const RealAlgebraic& s) {
  BivariatePolynomial product = c.f;
  if (sign_at(c.content, s) != 0) return product;
  product = product * BivariatePolynomial::r() * shifted(BivariatePolynomial::r(), 1);
  for (const BivariatePolynomial& border : c.part.borders)
    if (!reduced_at(border, s).is_zero()) product = product * border;
  return product;
}

/// A closed interval of r around the point that holds no other event over s and has none at its ends.
RationalInterval isolating_r(const LocalCurve& c, const TriangularPoint& p, Rational& margin) {
  const BivariatePolynomial events = events_over(c, p.s());
  for (margin = power_of_two(-4);; margin /= 16) {
    const RationalInterval r = p.refined_to(margin).r_interval();
    const RationalInterval wider = {r.lower - margin, r.upper + margin};
    if (roots_at(events, p.s(), wider.lower, wider.upper).size() == 1) return wider;
  }
}

/// An interval of s around the point in which f has no root at either end of r, and no other event lies.
RationalInterval isolating_s(const LocalCurve& c, const TriangularPoint& p, const RationalInterval& r,
                             Rational& margin) {
  const auto isolates = [&](const RationalInterval& s) {
    for (const Rational& end : {r.lower, r.upper})
      if (!real_roots(c.f.at_r(end), s.lower, s.upper).empty()) return false;
    return std::all_of(c.events.begin(), c.events.end(), [&](const Polynomial& event) {
      const std::vector<RealAlgebraic> roots = real_roots(event, s.lower, s.upper);
      return roots.empty() || (roots.size() == 1 && roots.front() == p.s());
    });
  };
  for (margin = power_of_two(-4);; margin /= 16) {
    const RationalInterval s = p.s().refined_to(margin).interval();
    const RationalInterval wider = {s.lower - margin, s.upper + margin};
    if (isolates(wider)) return wider;
  }
}

TriangularPoint rational_r(const RealAlgebraic& s, const Rational& r) {
  return {s, shifted(BivariatePolynomial::r(), r), {r, r}};
}

/// Whether a branch of f that enters the box over this rational s belongs to S there.
bool has_member(const LocalCurve& c, const Rational& s, const RationalInterval& r) {
  if (s < 0 || s > 1) return false;
  const std::vector<TriangularPoint> points =
      roots_at(c.f, RealAlgebraic(s), std::max(r.lower, Rational(0)), std::min(r.upper, Rational(1)));
  return std::any_of(points.begin(), points.end(),
                     [&](const TriangularPoint& p) { return c.part.contains(p); });
}

/// Whether the line through s belongs to the curve and an end of the r-interval on it to S.
bool has_member_on_line(const LocalCurve& c, const RealAlgebraic& s, const RationalInterval& r) {
  if (sign_at(c.content, s) != 0) return false;
  return std::ranges::any_of(std::array{r.lower, r.upper}, [&](const Rational& end) {
    return end >= 0 && end <= 1 && c.part.contains(rational_r(s, end));
  });
}

/// A superset of the isolated points: all are events over their s.
std::vector<TriangularPoint> candidates(const LocalCurve& c) {
  // Off the sides and where no border vanishes, a point is isolated only where f = f_r = 0.
  std::vector<TriangularPoint> points = component_points(c.f);
  const auto append = [&](const std::vector<TriangularPoint>& more) {
    points.insert(points.end(), more.begin(), more.end());
  };
  for (const BivariatePolynomial& border : c.part.borders)
    append(common_points(without(c.f, border), border));
  if (c.content.degree() <= 0) return points;
  for (const RealAlgebraic& s : real_roots(c.content, 0, 1)) append(roots_at(events_over(c, s), s, 0, 1));
  return points;
}

bool lies_in(const TriangularPoint& p, const RationalInterval& r) {
  return sign_at(shifted(BivariatePolynomial::r(), r.lower), p) >= 0 &&
         sign_at(shifted(BivariatePolynomial::r(), r.upper), p) <= 0;
}

}  // namespace

std::vector<IsolatedPoint> isolated_points(const BivariatePolynomial& f, const CurvePart& part) {
  const LocalCurve c = local_curve(f, part);
  std::vector<IsolatedPoint> result;
  for (const TriangularPoint& p : candidates(c)) {
    if (!c.part.contains(p)) continue;
    Rational r_margin;
    Rational s_margin;
    const RationalInterval r = isolating_r(c, p, r_margin);
    const RationalInterval s = isolating_s(c, p, r, s_margin);
    if (has_member(c, s.lower, r) || has_member(c, s.upper, r) || has_member_on_line(c, p.s(), r)) continue;
    const bool known = std::any_of(result.begin(), result.end(), [&](const IsolatedPoint& q) {
      return q.at.s() == p.s() && lies_in(q.at, r);
    });
    if (!known) result.push_back({p, std::min(r_margin, s_margin)});
  }
  return result;
}

}  // namespace exsect
