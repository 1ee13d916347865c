#include "line/line_curve.h"

#include <exsect/algebra/algebraic_value.h>
#include <exsect/algebra/resultant.h>

#include <algorithm>
#include <stdexcept>

#include "curve/plane_curve.h"
#include "line/isolated_points.h"

namespace exsect {
namespace {

using Values = std::vector<RealAlgebraic>;

BivariatePolynomial shifted_by(const BivariatePolynomial& f, const Rational& c) {
  return f - BivariatePolynomial::constant(c);
}

void add_values(Values& values, const BivariatePolynomial& lambda,
                const std::vector<TriangularPoint>& points) {
  for (const TriangularPoint& p : points) values.push_back(value_at(lambda, p));
}

/// lambda over the curve f = 0 in the square, no component of which has constant lambda. Between neighbouring
/// values at critical points (f = 0, singular or lambda stationary) and at points of the sides, the part of
/// the curve over the gap is a covering of it: one rational value in the gap decides for all.
std::vector<AlgebraicInterval> covered(const BivariatePolynomial& f, const BivariatePolynomial& lambda,
                                       const RationalInterval& range) {
  if (f.degree_r() <= 0 && f.degree_s() <= 0) return {};
  Values events = {RealAlgebraic(range.lower), RealAlgebraic(range.upper)};
  add_values(events, lambda, side_points(f));
  add_values(events, lambda, common_points(f, jacobian(f, lambda)));
  std::erase_if(events, [&](const RealAlgebraic& e) {
    return e.compare(range.lower) < 0 || e.compare(range.upper) > 0;
  });
  sort_unique(events);
  std::vector<AlgebraicInterval> result;
  for (std::size_t i = 0; i + 1 < events.size(); ++i) {
    const Rational sample = sample_between(events[i], events[i + 1]);
    if (!common_points(f, shifted_by(lambda, sample)).empty()) result.push_back({events[i], events[i + 1]});
  }
  return result;
}

/// The values of lambda on the one-dimensional real parts of f = 0 in the square, lambda constant on each.
Values constant_values(const BivariatePolynomial& f, const BivariatePolynomial& lambda) {
  const ContentAndPart parts = split_content(f);
  Values values;
  if (parts.content.degree() > 0)
    for (const RealAlgebraic& s : real_roots(parts.content, 0, 1))
      values.push_back(
          value_at(lambda, TriangularPoint(s, BivariatePolynomial::r(), RationalInterval{0, 0})));
  const BivariatePolynomial& g = parts.primitive;
  if (g.degree_r() <= 0) return values;
  Values events = {RealAlgebraic(0), RealAlgebraic(1)};
  std::vector<Polynomial> candidates = {g.coefficient(g.degree_r()), g.at_r(0), g.at_r(1)};
  if (g.degree_r() > 1) candidates.push_back(discriminant_r(g));
  for (const Polynomial& c : candidates)
    if (c.degree() > 0)
      for (const RealAlgebraic& s : real_roots(c, 0, 1)) events.push_back(s);
  sort_unique(events);
  for (std::size_t i = 0; i + 1 < events.size(); ++i)
    add_values(values, lambda, roots_at(g, RealAlgebraic(sample_between(events[i], events[i + 1])), 0, 1));
  return values;
}

}  // namespace

void sort_unique(std::vector<RealAlgebraic>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

Rational sample_between(RealAlgebraic a, RealAlgebraic b) {
  for (Rational width = power_of_two(-8);; width *= width) {
    if (a.interval().upper < b.interval().lower)
      return simplest_between(a.interval().upper, b.interval().lower);
    a = a.refined_to(width);
    b = b.refined_to(width);
  }
}

std::vector<AlgebraicInterval> merged(std::vector<AlgebraicInterval> intervals) {
  std::sort(intervals.begin(), intervals.end(),
            [](const AlgebraicInterval& a, const AlgebraicInterval& b) { return a.from < b.from; });
  std::vector<AlgebraicInterval> result;
  for (const AlgebraicInterval& i : intervals) {
    if (result.empty() || result.back().to < i.from)
      result.push_back(i);
    else if (result.back().to < i.to)
      result.back().to = i.to;
  }
  return result;
}

CurveOnLine curve_on_line(const BivariatePolynomial& f, const BivariatePolynomial& lambda,
                          const RationalInterval& range) {
  const BivariatePolynomial curve = squarefree(f);
  const BivariatePolynomial constant = gcd(curve, jacobian(curve, lambda));
  CurveOnLine result;
  result.lambda = covered(exact_quotient(curve, constant), lambda, range);
  for (const RealAlgebraic& value : constant_values(constant, lambda))
    if (value.compare(range.lower) >= 0 && value.compare(range.upper) <= 0)
      result.lambda.push_back({value, value});
  result.lambda = merged(std::move(result.lambda));
  const BivariatePolynomial above = shifted_by(lambda, range.lower), below = shifted_by(lambda, range.upper);
  const auto in_range = [&](const TriangularPoint& p) {
    return sign_at(above, p) >= 0 && sign_at(below, p) <= 0;
  };
  result.isolated = isolated_points(curve, {{above, below}, in_range});
  return result;
}

CurveOnLine square_on_line(const BivariatePolynomial& lambda, const RationalInterval& range) {
  // Extremes of lambda: at corners, stationary on a side, or stationary inside. Where the stationary points
  // form a curve, lambda is constant on its components, so a point of each is enough.
  Values values;
  for (const int r : {0, 1})
    for (const int s : {0, 1}) values.emplace_back(lambda(r, s));
  const BivariatePolynomial lambda_r = lambda.derivative_r();
  const BivariatePolynomial lambda_s = lambda.derivative_s();
  add_values(values, lambda, side_points(lambda_r));
  add_values(values, lambda, side_points(lambda_s));
  const BivariatePolynomial common = gcd(lambda_r, lambda_s);
  if (!common.is_zero()) {
    add_values(values, lambda, component_points(squarefree(common)));
    add_values(values, lambda,
               common_points(exact_quotient(lambda_r, common), exact_quotient(lambda_s, common)));
  }
  sort_unique(values);
  const RealAlgebraic from = std::max(values.front(), RealAlgebraic(range.lower));
  const RealAlgebraic to = std::min(values.back(), RealAlgebraic(range.upper));
  if (from < to || (from == to && common.is_zero())) return {{{from, to}}, {}};
  if (from == to)
    return curve_on_line(shifted_by(lambda, from == range.lower ? range.lower : range.upper), lambda, range);
  return {};
}

}  // namespace exsect
