// Points of a curve by its factors, against those of the product.
#include "curve/factor_points.h"

#include <exsect/solver/curve_graph.h>

#include <algorithm>

#include "algebra/random_numbers.h"
#include "curve/plane_curve.h"
#include "curve/region_outline.h"
#include "support/catch.h"

namespace exsect::factor_points_test {
namespace {

const BivariatePolynomial u = BivariatePolynomial::r(), v = BivariatePolynomial::s();
BivariatePolynomial number(const Rational& q) { return BivariatePolynomial::constant(q); }
/// A circle with its centre in (a,b), of the radius 1/3.
BivariatePolynomial circle(const Rational& a, const Rational& b) {
  const BivariatePolynomial x = u - number(a), y = v - number(b);
  return x * x + y * y - number(Rational(1, 9));
}

std::vector<BivariatePolynomial> exchanged(const std::vector<BivariatePolynomial>& factors) {
  std::vector<BivariatePolynomial> result;
  for (const BivariatePolynomial& f : factors) result.push_back(f.exchanged());
  return result;
}
BivariatePolynomial product(const std::vector<BivariatePolynomial>& factors) {
  BivariatePolynomial result = number(1);
  for (const BivariatePolynomial& f : factors) result = result * f;
  return result;
}

/// Nodes, arcs, isolated points, components, singular nodes.
std::array<int, 5> shape(const CurveGraph& graph) {
  return {static_cast<int>(graph.nodes.size()), static_cast<int>(graph.arcs.size()), graph.isolated_points(),
          graph.components(),
          static_cast<int>(std::ranges::count_if(graph.nodes, [](const auto& n) { return n.is_singular; }))};
}

}  // namespace

TEST_CASE("factor points: factors that polynomials have in common come once, and multiple ones") {
  const BivariatePolynomial a = circle(0, 0), b = circle(1, 0), c = u - v;
  const std::vector<BivariatePolynomial> factors = coprime_factors({a * c, number(7), b * b * c, c, a * b});
  CHECK(factors.size() == 2);
  CHECK(exact_quotient(product(factors), a * b * c).degree_r() == 0);
  for (std::size_t i = 0; i < factors.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) CHECK(gcd(factors[i], factors[j]).degree_r() < 1);
}

TEST_CASE("factor points: a common point is one, with both of its factors") {
  const Rational third(1, 3), half(1, 2);
  // Circles that touch in (1/2, 1/2), and the line through their centres.
  const std::vector<BivariatePolynomial> factors =
      exchanged({circle(half - third, half), circle(half + third, half), v - number(half)});
  const std::vector<FactorPoint> touch = points_over(factors, half);
  REQUIRE(touch.size() == 1);
  CHECK(touch[0].factors == std::vector<std::size_t>{0, 1, 2});
  const std::vector<FactorPoint> beside = points_over(factors, third);
  REQUIRE(beside.size() == 3);
  for (const std::size_t i : {0, 2}) CHECK(beside[i].factors == std::vector<std::size_t>{0});
  CHECK(beside[1].factors == std::vector<std::size_t>{2});
  // Over an irrational u: the crossings of a circle and a diagonal.
  const RealAlgebraic place = real_roots(Polynomial{Rational(1, 4) - Rational(1, 18), -1, 1}, 0, 1).back();
  const std::vector<FactorPoint> over = points_over(exchanged({circle(half, half), u - v}), place);
  REQUIRE(over.size() == 2);
  CHECK(over[0].factors.size() == 1);
  CHECK(over[1].factors == std::vector<std::size_t>{0, 1});
}

TEST_CASE("factor points: the graph of the product") {
  const std::uint64_t seed = 17;
  INFO("seed " << seed);
  std::mt19937_64 generator(seed);
  const auto fraction = [&] { return Rational(static_cast<int>(generator() % 9), 8); };
  for (int round = 0; round < 4; ++round) {
    INFO("round " << round);
    std::vector<BivariatePolynomial> curves = {circle(fraction(), fraction()), circle(fraction(), fraction()),
                                               u - number(fraction()) * v - number(fraction() / 4), v,
                                               v - number(fraction()) * u};
    const std::vector<BivariatePolynomial> factors = coprime_factors(curves);
    const CurveGraph graph = curve_graph_of_factors(factors), whole = curve_graph(product(factors));
    CHECK(shape(graph) == shape(whole));
    for (const CurveBranch& arc : graph.arcs) {
      if (graph.nodes[arc.from].u == graph.nodes[arc.to].u) continue;
      CHECK(sign_at(graph.factors[arc.factor].exchanged(), arc.inside) == 0);
    }
    for (std::size_t i = 0; i < graph.columns.size(); ++i) {
      const Rational at =
          simplest_between(graph.values[i].interval().upper, graph.values[i + 1].interval().lower);
      const std::vector<FactorRoot> roots = roots_over(graph.factors, at);
      const Polynomial in_v = whole.swept.at_r(at);
      const auto expected = in_v.degree() < 1 ? std::vector<RealAlgebraic>{} : real_roots(in_v, 0, 1);
      REQUIRE(roots.size() == expected.size());
      for (std::size_t k = 0; k < roots.size(); ++k) {
        CHECK(roots[k].v == expected[k]);
        CHECK(graph.arcs[graph.columns[i][k]].factor == roots[k].factor);
      }
    }
  }
}

TEST_CASE("factor points: a region with an oblique corner between other points of its bounds") {
  // Between the hyperbolas, u = 1 and v = 1. Isolating intervals of points of two factors may overlap.
  const BivariatePolynomial a = u * v * v - v + number(Rational(1, 5));
  const BivariatePolynomial b = u * (v - number(Rational(3, 4))) - number(Rational(1, 16));
  const BivariatePolynomial c = u * v - number(Rational(1, 4));
  for (const std::vector<BivariatePolynomial>& bounds :
       {std::vector{a, b, c}, std::vector{c, b, a}, exchanged({a, b, c})}) {
    CurveRegion region;
    region.bounds = bounds;
    region.clauses = {{0}, {1}, {2}};
    const RegionOutline found = outline(region);
    REQUIRE(found.parts.size() == 1);
    CHECK(found.parts[0].chains.size() == 1);
    CHECK(found.curves.empty());
    CHECK(found.points.empty());
  }
  const std::vector<FactorPoint> over = points_over(exchanged({a, b, c}), Rational(9, 10));
  for (std::size_t k = 0; k + 1 < over.size(); ++k)
    CHECK(over[k].at.r_interval().upper < over[k + 1].at.r_interval().lower);
}

}  // namespace exsect::factor_points_test
