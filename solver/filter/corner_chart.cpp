#include "filter/corner_chart.h"

#include <algorithm>

namespace exsect::filter {

namespace {

constexpr int kMostPartings = 10;

/// Of |f| on an interval, from the Taylor coefficients in its middle: a lower bound, negative perhaps, and an
/// upper one.
struct Range {
  Rational least;
  Rational most;
};
Range range_of(const Polynomial& f, const RationalInterval& c) {
  const Polynomial moved = f.compose(Polynomial{c.midpoint(), 1});
  const Rational radius = c.width() / 2;
  Rational rest = 0, step = 1;
  for (int k = 1; k <= moved.degree(); ++k) {
    step *= radius;
    rest += abs(moved.coefficient(k)) * step;
  }
  const Rational middle = abs(moved.coefficient(0));
  return {middle - rest, middle + rest};
}

/// >= t^n, n >= 0.
Rational power_of_t(const CornerChart& chart, long n) {
  long exponent = floor_of(chart.k * n, chart.edge.p_weight);
  long lower = 0;  // 2^lower <= c
  while (power_of_two(lower) > chart.c.lower) --lower;
  while (power_of_two(lower + 1) <= chart.c.lower) ++lower;
  if (chart.k + lower > 0)
    exponent = std::max(exponent, floor_of((chart.k + lower) * n, chart.edge.q_weight));
  return power_of_two(-exponent);
}

/// Of h(t,c) = f/t^degree less its terms without t: bounds of h and its derivative by c and, as long as 2 t
/// is in the chart, of t times that by t.
struct Beside {
  Rational value;
  Rational slope;
  Rational rate;
};

/// (14.124); empty if f has terms of lower weight. The rest at complex numbers: c in discs of radius
/// c.lower/4, t in discs of radius t.
std::optional<Beside> beside(const PlaneSeries& f, const CornerChart& chart, int degree) {
  Beside result{0, 0, 0};
  const PolygonEdge& edge = chart.edge;
  const Rational& most = chart.c.upper;
  for (int i = 0; i <= f.order(); ++i)
    for (int j = 0; i + j <= f.order(); ++j) {
      const int over = edge.p_weight * i + edge.q_weight * j - degree;
      const Rational& c = f.coefficient(i, j);
      if (c == 0 || over == 0) continue;
      if (over < 0) return std::nullopt;
      const Rational size = abs(c) * power_of_t(chart, over);
      result.value += size * power(most, j);
      result.rate += size * Rational(over) * power(most, j);
      if (j > 0) result.slope += size * Rational(j) * power(most, j - 1);
    }
  const int n = f.order() + 1;
  const int over = std::min(edge.p_weight, edge.q_weight) * n - degree;
  if (over < 0) return std::nullopt;
  const Rational farthest = std::max(Rational(1), power(most + chart.c.lower / 4, n));
  const Rational rest = f.rest() * farthest * power_of_t(chart, over);
  result.value += rest;
  result.slope += rest * 4 / chart.c.lower;
  result.rate += rest;
  return result;
}

/// The sum of the terms of least weight, as a polynomial in c.
struct Leading {
  int degree;
  Polynomial in_c;
};
std::optional<Leading> leading(const PlaneSeries& f, const PolygonEdge& edge) {
  std::optional<int> least;
  std::vector<Rational> coefficients;
  for (int i = 0; i <= f.order(); ++i)
    for (int j = 0; i + j <= f.order(); ++j) {
      const int degree = edge.p_weight * i + edge.q_weight * j;
      if (f.coefficient(i, j) == 0 || (least && degree > *least)) continue;
      if (!least || degree < *least) coefficients.assign(static_cast<std::size_t>(f.order()) + 1, 0);
      least = degree;
      coefficients[static_cast<std::size_t>(j)] += f.coefficient(i, j);
    }
  if (!least) return std::nullopt;
  return Leading{*least, Polynomial(coefficients)};
}

bool is_empty_in_parts(const PlaneSeries& g, const CornerChart& chart, int partings) {
  const auto others = beside(g, chart, chart.edge.degree);
  if (others && range_of(chart.edge.in_c, chart.c).least > others->value) return true;
  if (partings == 0 || !others) return false;
  const Rational middle = chart.c.midpoint();
  return is_empty_in_parts(g, {chart.edge, {chart.c.lower, middle}, chart.k}, partings - 1) &&
         is_empty_in_parts(g, {chart.edge, {middle, chart.c.upper}, chart.k}, partings - 1);
}

}  // namespace

int sign_in(const PlaneSeries& f, const CornerChart& chart) {
  const auto first = leading(f, chart.edge);
  const auto others = first ? beside(f, chart, first->degree) : std::nullopt;
  if (!others || !(range_of(first->in_c, chart.c).least > others->value)) return 0;
  return sign(first->in_c(chart.c.midpoint()));
}

bool is_empty(const PlaneSeries& g, const CornerChart& chart) {
  return is_empty_in_parts(g, chart, kMostPartings);
}

// (14.125).
bool is_one_branch(const PlaneSeries& g, const CornerChart& chart) {
  const auto others = beside(g, chart, chart.edge.degree);
  if (!others || !(range_of(chart.edge.in_c.derivative(), chart.c).least > others->slope)) return false;
  const Rational lower = chart.edge.in_c(chart.c.lower), upper = chart.edge.in_c(chart.c.upper);
  return abs(lower) > others->value && abs(upper) > others->value && sign(lower) != sign(upper);
}

// (14.126). With t c' = -t h_t / (e' + h_c) along the zeros.
bool all_increase(const CornerEquation& equation, const CornerChart& chart) {
  const PolygonEdge& edge = chart.edge;
  const auto of_normal = beside(equation.normal, chart, edge.degree);
  if (!of_normal) return false;
  const Rational least = range_of(edge.in_c.derivative(), chart.c).least - of_normal->slope;
  if (!(least > 0)) return false;
  const Rational turn = of_normal->rate / least;
  if (!(turn < Rational(edge.q_weight) * chart.c.lower)) return false;
  return std::ranges::all_of(equation.bound, [&](const PlaneSeries& f) {
    const auto first = leading(f, edge);
    const auto others = first ? beside(f, chart, first->degree) : std::nullopt;
    if (!others) return false;
    const Rational slope = range_of(first->in_c.derivative(), chart.c).most + others->slope;
    return Rational(first->degree) * (range_of(first->in_c, chart.c).least - others->value) >
           others->rate + slope * turn;
  });
}

}  // namespace exsect::filter
