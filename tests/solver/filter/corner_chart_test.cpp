#include "filter/corner_chart.h"

#include "support/catch.h"

namespace exsect::corner_chart_test {
namespace {

using filter::CornerChart;
using filter::CornerEquation;
using filter::PlaneSeries;
using filter::PolygonEdge;

struct Term {
  int i, j;
  Rational c;
};
PlaneSeries series_of(const std::vector<Term>& terms, const Rational& rest = 0) {
  PlaneSeries f(5, Rational(1, 2));
  for (const Term& t : terms) f.add(PlaneSeries::power(5, Rational(1, 2), t.i, t.j), t.c);
  f.widen(rest);
  return f;
}

const Term kP = {1, 0, 1}, kQ = {0, 1, 1};
/// q^2 = p^3 (1 + p): c = 1 + t^2/2 - ...
const std::vector<Term> kCusp = {{0, 2, 1}, {3, 0, -1}, {4, 0, -1}};
const RationalInterval kAroundOne = {Rational(7, 8), Rational(9, 8)};

PolygonEdge edge_of(const PlaneSeries& f) {
  const auto edges = filter::newton_polygon(f);
  REQUIRE(edges.size() == 1);
  return edges[0];
}

}  // namespace

TEST_CASE("corner chart: one branch of a cusp, and none beside it", "[filter]") {
  const PlaneSeries f = series_of(kCusp);
  const PolygonEdge edge = edge_of(f);
  CHECK(is_one_branch(f, {edge, kAroundOne, 4}));
  CHECK_FALSE(is_one_branch(f, {edge, kAroundOne, 2}));  // p = 1/4: c may leave it
  CHECK_FALSE(is_one_branch(f, {edge, {Rational(9, 8), Rational(5, 4)}, 6}));
  CHECK(is_empty(f, {edge, {Rational(9, 8), 8}, 4}));
  CHECK(is_empty(f, {edge, {Rational(1, 8), Rational(7, 8)}, 4}));
  CHECK_FALSE(is_empty(f, {edge, {Rational(1, 2), 2}, 8}));
  // A rest of order 6 is t^12 or more, against t^6.
  CHECK(is_one_branch(series_of(kCusp, 10), {edge, kAroundOne, 4}));
  CHECK_FALSE(is_one_branch(series_of(kCusp, 100000), {edge, kAroundOne, 4}));
}

TEST_CASE("corner chart: signs along a branch", "[filter]") {
  const PolygonEdge edge = edge_of(series_of(kCusp));
  const CornerChart chart{edge, kAroundOne, 6};
  const Term less = {1, 0, -1}, most = {2, 0, 3};
  CHECK(sign_in(series_of({kP, {0, 1, -1}}), chart) == 1);  // t^2 - c t^3
  CHECK(sign_in(series_of({less, kQ}), chart) == -1);
  CHECK(sign_in(series_of({most}), chart) == 1);
  CHECK(sign_in(series_of({}), chart) == 0);
  CHECK(sign_in(series_of({}, 1), chart) == 0);
  CHECK(sign_in(series_of({{0, 2, 1}, {3, 0, -1}}), chart) == 0);  // zero along it
  CHECK(sign_in(series_of({{5, 0, 1}}, 1), chart) == 1);           // t^10, and a rest of t^12
  CHECK(sign_in(series_of({{0, 5, 1}}, 1), chart) == 0);           // t^15
}

TEST_CASE("corner chart: parameters that increase", "[filter]") {
  const PlaneSeries f = series_of(kCusp);
  const PolygonEdge edge = edge_of(f);
  const auto increase = [&](const std::vector<Term>& a, long k) {
    const CornerEquation equation = {{{0, 1}, {2, 3}}, {series_of(a), series_of({kQ})}, f};
    const CornerChart chart{edge, kAroundOne, k};
    return is_one_branch(f, chart) && sign_in(equation.bound[0], chart) == 1 && all_increase(equation, chart);
  };
  CHECK(increase({kP}, 6));
  CHECK(increase({{2, 0, 1}, kQ}, 6));
  // p - 100 p^2 turns at 1/200.
  CHECK_FALSE(increase({kP, {2, 0, -100}}, 7));
  CHECK(increase({kP, {2, 0, -100}}, 10));
  CHECK_FALSE(increase({{1, 0, -1}}, 6));
}

}  // namespace exsect::corner_chart_test
