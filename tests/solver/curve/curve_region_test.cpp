#include <exsect/solver/curve_graph.h>

#include <algorithm>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::curve_region_test {
namespace {

const BivariatePolynomial u = BivariatePolynomial::r();
const BivariatePolynomial v = BivariatePolynomial::s();
BivariatePolynomial number(const Rational& q) { return BivariatePolynomial::constant(q); }
const BivariatePolynomial a = u - number(Rational(1, 2));
const BivariatePolynomial b = v - number(Rational(1, 2));
const BivariatePolynomial disc = a * a + b * b - number(Rational(1, 9));
const BivariatePolynomial minus = number(-1);

CurveRegion region(std::vector<BivariatePolynomial> bounds, std::vector<std::vector<std::size_t>> clauses) {
  CurveRegion result;
  result.bounds = std::move(bounds);
  result.clauses = std::move(clauses);
  return result;
}
CurveRegion all_of(const BivariatePolynomial& g, const BivariatePolynomial& h) {
  return region({g, h}, {{0}, {1}});
}
CurveRegion any_of(const BivariatePolynomial& g, const BivariatePolynomial& h) {
  return region({g, h}, {{0, 1}});
}

/// Nodes, arcs, components, isolated points.
using Shape = std::array<int, 4>;
Shape shape(const CurveGraph& graph) {
  return {static_cast<int>(graph.nodes.size()), static_cast<int>(graph.arcs.size()), graph.components(),
          graph.isolated_points()};
}
Shape shape(const BivariatePolynomial& f, const CurveRegion& part) { return shape(curve_graph(f, part)); }

TEST_CASE("quarters of a circle, and what is left without one") {
  for (const BivariatePolynomial& g : {a, minus * a})
    for (const BivariatePolynomial& h : {b, minus * b}) {
      CHECK(shape(disc, all_of(g, h)) == Shape{2, 1, 1, 0});
      CHECK(shape(disc, any_of(g, h)) == Shape{3, 2, 1, 0});  // one turning point inside
    }
  CHECK(shape(disc, all_of(a, minus * a)) == Shape{2, 0, 2, 2});  // closed: two points
  CHECK(shape(disc, any_of(a, minus * a)) == Shape{4, 4, 1, 0});
  CHECK(shape(disc, all_of(a, a)) == shape(disc, a));
  CHECK(shape(disc, any_of(a, a)) == shape(disc, a));
}

TEST_CASE("a bound that does not change the region leaves no nodes") {
  CHECK(shape(disc, any_of(a, number(1))) == shape(curve_graph(disc)));
  CHECK(shape(disc, any_of(a, number(0))) == Shape{4, 4, 1, 0});  // but 0, which vanishes along all arcs
  CHECK(shape(disc, all_of(a, number(-1))) == Shape{0, 0, 0, 0});
  CHECK(shape(disc, any_of(b, number(-1))) == shape(disc, b));
  CHECK(shape(disc, any_of(a, a + number(1))) == shape(curve_graph(disc)));
  // On a line u = const as well.
  CHECK(shape(a, any_of(b, number(1))) == Shape{2, 1, 1, 0});
  CHECK(shape(a, any_of(b, v - number(Rational(1, 4)))) == Shape{2, 1, 1, 0});
  CHECK(shape(a, all_of(b, number(Rational(3, 4)) - v)) == Shape{2, 1, 1, 0});
}

TEST_CASE("a closed region keeps points and arcs that lie on its rim") {
  CHECK(shape(disc, all_of(a - number(Rational(1, 3)), b)) == Shape{1, 0, 1, 1});
  CHECK(shape(disc, all_of(minus * disc, a)) == shape(disc, a));
  CHECK(shape(b, all_of(b, minus * b)) == Shape{2, 1, 1, 0});
  CHECK(shape(a, all_of(a, minus * a)) == Shape{2, 1, 1, 0});
  // Along b = 0 the bound is 0 throughout; where its other factor is as well there is a node.
  CHECK(shape(b, all_of(b * b * (a - number(Rational(1, 4))), number(1))) == Shape{3, 2, 1, 0});
}

TEST_CASE("a bound with a multiple factor of the curve still cuts the rest") {
  // b^2 c >= 0 holds on b = 0, where it is 0; beside it, it is c >= 0.
  const BivariatePolynomial c = v - number(Rational(3, 4));
  CHECK(shape(curve_graph(a * b, b * b * c)) == Shape{5, 3, 2, 0});
  CHECK(shape(curve_graph((v - u) * b, b * b * c)) == Shape{6, 4, 2, 0});
  CHECK(shape(v - u, c) == Shape{2, 1, 1, 0});
}

int sign_of(const BivariatePolynomial& f, const Rational& x, const RealAlgebraic& y) {
  return sign_at(f.at_r(x), y);
}

TEST_CASE("random regions keep over every line what signs say, and complements share the curve") {
  const std::uint64_t seed = 28011;
  INFO("seed " << seed);
  test::Random random(seed);
  const auto small = [&](int parts) { return number(Rational(random.integer(-6, 6), parts)); };
  for (int round = 0; round < 12; ++round) {
    const BivariatePolynomial f =
        round % 3 == 0 ? disc : disc + small(4) * u * v + small(32) - small(20) * v * v;
    if (f.is_zero()) continue;
    std::vector<BivariatePolynomial> bounds;
    for (int i = 0; i < 3; ++i) bounds.push_back(small(4) * a + small(4) * b + small(40));
    const CurveRegion part = region(bounds, {{0, 1}, {2}});
    const CurveGraph graph = curve_graph(f, part);
    for (std::size_t i = 0; i + 1 < graph.values.size(); ++i) {
      const Rational x =
          simplest_between(graph.values[i].interval().upper, graph.values[i + 1].interval().lower);
      const std::vector<RealAlgebraic> points = real_roots(graph.swept.at_r(x), 0, 1);
      REQUIRE(points.size() == graph.columns[i].size());
      for (std::size_t k = 0; k < points.size(); ++k) {
        const auto holds = [&](std::size_t bound) { return sign_of(bounds[bound], x, points[k]) >= 0; };
        const bool is_kept = (holds(0) || holds(1)) && holds(2);
        CHECK((graph.columns[i][k] != CurveGraph::dropped) == is_kept);
      }
    }
    int ends = 0;
    for (const CurveNode& node : graph.nodes) ends += node.degree();
    CHECK(ends == 2 * static_cast<int>(graph.arcs.size()));
  }
}

}  // namespace
}  // namespace exsect::curve_region_test
