#include <exsect/solver/curve_graph.h>

#include <algorithm>

#include "algebra/random_numbers.h"
#include "curve/curve_factors.h"
#include "support/catch.h"

namespace exsect::curve_graph_test {
namespace {

const BivariatePolynomial u = BivariatePolynomial::r();
const BivariatePolynomial v = BivariatePolynomial::s();
BivariatePolynomial number(const Rational& q) { return BivariatePolynomial::constant(q); }
const BivariatePolynomial a = u - number(Rational(1, 2));
const BivariatePolynomial b = v - number(Rational(1, 2));

BivariatePolynomial circle(const Rational& x, const Rational& y, const Rational& squared_radius) {
  return (u - number(x)) * (u - number(x)) + (v - number(y)) * (v - number(y)) - number(squared_radius);
}

struct Shape {
  int nodes, arcs, components, isolated, singular;
  friend bool operator==(const Shape&, const Shape&) = default;
};
std::ostream& operator<<(std::ostream& out, const Shape& s) {
  return out << s.nodes << " nodes, " << s.arcs << " arcs, " << s.components << " components, " << s.isolated
             << " isolated, " << s.singular << " singular";
}

Shape shape(const CurveGraph& graph) {
  const auto singular = std::count_if(graph.nodes.begin(), graph.nodes.end(),
                                      [](const CurveNode& node) { return node.is_singular; });
  return {static_cast<int>(graph.nodes.size()), static_cast<int>(graph.arcs.size()), graph.components(),
          graph.isolated_points(), static_cast<int>(singular)};
}
Shape shape(const BivariatePolynomial& f) { return shape(curve_graph(f)); }

std::vector<int> multiplicities(const BivariatePolynomial& f) {
  std::vector<int> result;
  for (const CurveBranch& arc : curve_graph(f).arcs) result.push_back(arc.multiplicity);
  std::sort(result.begin(), result.end());
  return result;
}

TEST_CASE("no curve, and the zero polynomial") {
  CHECK(shape(number(-3)) == Shape{0, 0, 0, 0, 0});
  CHECK(shape(u * u + v * v + number(1)) == Shape{0, 0, 0, 0, 0});
  CHECK(shape(u + v - number(3)) == Shape{0, 0, 0, 0, 0});
  CHECK(shape(u - number(2)) == Shape{0, 0, 0, 0, 0});
  CHECK(shape(v + number(1)) == Shape{0, 0, 0, 0, 0});
  CHECK_THROWS_AS(curve_graph({}), std::domain_error);
  CHECK_THROWS_AS(curve_factors({}), std::domain_error);
}

TEST_CASE("circles, isolated points and what is beside them") {
  CHECK(shape(circle(Rational(1, 2), Rational(1, 2), Rational(1, 9))) == Shape{2, 2, 1, 0, 0});
  CHECK(shape(circle(Rational(1, 2), Rational(1, 3), 0)) == Shape{1, 0, 1, 1, 1});
  CHECK(shape(circle(0, 0, 0)) == Shape{1, 0, 1, 1, 1});
  CHECK(shape(circle(0, Rational(1, 3), 0)) == Shape{1, 0, 1, 1, 1});
  CHECK(shape(circle(-1, Rational(1, 3), 1)) == Shape{1, 0, 1, 1, 0});
  CHECK(shape(circle(Rational(1, 2), -1, 1)) == Shape{1, 0, 1, 1, 0});
  CHECK(shape(u + v) == Shape{1, 0, 1, 1, 0});
  CHECK(shape(u + v - number(2)) == Shape{1, 0, 1, 1, 0});
  // x^2 = 2 y^2 + ..., an isolated point with irrational coordinates in both directions
  const BivariatePolynomial p = u * u - number(Rational(1, 2)), q = v * v - number(Rational(1, 3));
  CHECK(shape(p * p + q * q) == Shape{1, 0, 1, 1, 1});
  for (const int k : {10, 66, 200}) {
    const BivariatePolynomial e = number(power_of_two(-k));
    CHECK(shape(p * p + q * q - e) == Shape{2, 2, 1, 0, 0});
    CHECK(shape(p * p + q * q + e) == Shape{0, 0, 0, 0, 0});
    CHECK(shape(u + v - e) == Shape{2, 1, 1, 0, 0});
    CHECK(shape(u + v + e) == Shape{0, 0, 0, 0, 0});
  }
  // touching the sides from inside: four points on sides, arcs between them
  CHECK(shape(circle(Rational(1, 2), Rational(1, 2), Rational(1, 4))) == Shape{4, 4, 1, 0, 0});
}

TEST_CASE("singular points of every kind") {
  CHECK(shape(a * b) == Shape{5, 4, 1, 0, 1});
  CHECK(shape(a * a - b * b) == Shape{5, 4, 1, 0, 1});
  CHECK(shape(a * b * (a - b)) == Shape{7, 6, 1, 0, 1});
  CHECK(shape(b * b - a * a * a) == Shape{3, 2, 1, 0, 1});  // a cusp, folded
  CHECK(shape(a * a - b * b * b) == Shape{3, 2, 1, 0, 1});  // a cusp that one arc passes
  CHECK(shape(b * (b - a * a)) == Shape{5, 4, 1, 0, 1});    // a tacnode
  CHECK(shape(b * b * b - a * a * a * a) == Shape{3, 2, 1, 0, 1});
  CHECK(shape(b * b - a * a * (a + number(Rational(1, 4)))) == Shape{4, 4, 1, 0, 1});  // a loop
  CHECK(shape(b * b - a * a * (a - number(Rational(1, 4)))) == Shape{4, 2, 2, 1, 1});  // a point and an arc
  // two circles, crossing, touching from both sides, apart
  const BivariatePolynomial left = circle(Rational(2, 5), Rational(1, 2), Rational(1, 100));
  CHECK(shape(left * circle(Rational(1, 2), Rational(1, 2), Rational(1, 100))) == Shape{6, 8, 1, 0, 2});
  CHECK(shape(left * circle(Rational(3, 5), Rational(1, 2), Rational(1, 100))) == Shape{3, 4, 1, 0, 1});
  CHECK(shape(left * circle(Rational(7, 10), Rational(1, 2), Rational(1, 100))) == Shape{4, 4, 2, 0, 0});
}

TEST_CASE("a turning point beside a steep arc") {
  // B^3 - p B + e: a fold at p of about e^(2/3), a third branch at a distance of about e^(1/3)
  const BivariatePolynomial p = u * u - number(Rational(1, 2)), steep = b + number(5) * p;
  for (const int k : {30, 60, 90, 150})
    for (const int sign : {-1, 1}) {
      INFO("2^-" << k << ", sign " << sign);
      const BivariatePolynomial f = steep * steep * steep - p * steep + number(sign * power_of_two(-k));
      CHECK(shape(f) == Shape{5, 3, 2, 0, 0});
    }
}

TEST_CASE("lines along the axes, sides and multiple factors") {
  CHECK(shape(u) == Shape{2, 1, 1, 0, 0});
  CHECK(shape(v) == Shape{2, 1, 1, 0, 0});
  CHECK(shape(u * v * (u - number(1)) * (v - number(1))) == Shape{4, 4, 1, 0, 4});
  CHECK(shape((u * u - number(Rational(1, 2))) * b) == Shape{5, 4, 1, 0, 1});
  CHECK(shape(v * a) == Shape{4, 3, 1, 0, 1});
  CHECK(shape(v * (v - a * a)) == Shape{5, 4, 1, 0, 1});
  CHECK(multiplicities(a * a) == std::vector<int>{2});
  CHECK(multiplicities(b * b * b) == std::vector<int>{3});
  CHECK(multiplicities(a * b * b) == std::vector<int>{1, 1, 2, 2});
  CHECK(multiplicities(circle(Rational(1, 2), Rational(1, 2), Rational(1, 9)) * b * b) ==
        std::vector<int>{1, 1, 2, 2, 2});
  CHECK(multiplicities((u * u + number(1)) * (u * u + number(1)) * b) == std::vector<int>{1});
}

TEST_CASE("a half of a curve") {
  const BivariatePolynomial disc = circle(Rational(1, 2), Rational(1, 2), Rational(1, 9));
  CHECK(shape(curve_graph(disc, b)) == Shape{2, 1, 1, 0, 0});
  CHECK(shape(curve_graph(disc, a)) == Shape{3, 2, 1, 0, 0});
  CHECK(shape(curve_graph(disc, number(1))) == Shape{2, 2, 1, 0, 0});
  CHECK(shape(curve_graph(disc, number(-1))) == Shape{0, 0, 0, 0, 0});
  CHECK(shape(curve_graph(a * b, a + b)) == Shape{3, 2, 1, 0, 1});
  CHECK(shape(curve_graph(a * a, b)) == Shape{2, 1, 1, 0, 0});
  CHECK(shape(curve_graph(b * b, a)) == Shape{2, 1, 1, 0, 0});
  CHECK(shape(curve_graph(a * b, a)) == Shape{4, 3, 1, 0, 1});  // h vanishes on an arc, which stays
  CHECK(shape(curve_graph(disc, u - number(Rational(5, 6)))) == Shape{1, 0, 1, 1, 0});
}

TEST_CASE("factors by multiplicity multiply to the polynomial") {
  const BivariatePolynomial f = a * b * b * (u * v - number(3)) * (u * v - number(3)) * u * u * u;
  BivariatePolynomial product = number(1);
  std::vector<int> found;
  for (const CurveFactor& factor : curve_factors(f)) {
    found.push_back(factor.multiplicity);
    for (int k = 0; k < factor.multiplicity; ++k) product = product * factor.factor;
  }
  CHECK(found == std::vector<int>{1, 2, 3});
  CHECK(gcd(product, f) == gcd(f, f));
  CHECK(product.degree_r() == f.degree_r());
  CHECK(product.degree_s() == f.degree_s());
}

int arcs_over(const CurveGraph& graph, const Rational& at) {
  return static_cast<int>(std::count_if(graph.arcs.begin(), graph.arcs.end(), [&](const CurveBranch& arc) {
    return graph.nodes[arc.from].u.compare(at) < 0 && graph.nodes[arc.to].u.compare(at) > 0;
  }));
}

TEST_CASE("random products have the points over u that Sturm counts, and the same parts when exchanged") {
  const std::uint64_t seed = 26010;
  INFO("seed " << seed);
  test::Random random(seed);
  const auto polynomial = [&](int degree) {
    std::vector<Polynomial> rows;
    for (int i = 0; i <= degree; ++i) rows.push_back(random.polynomial(degree, 9, 3));
    return BivariatePolynomial(rows);
  };
  for (int round = 0; round < 12; ++round) {
    const BivariatePolynomial one = polynomial(2), two = polynomial(1 + round % 2);
    const BivariatePolynomial f = round % 3 == 0   ? one * two
                                  : round % 3 == 1 ? one * two * two
                                                   : one * one + two * two;
    if (f.is_zero()) continue;
    const CurveGraph graph = curve_graph(f), exchanged = curve_graph(f.exchanged());
    INFO("round " << round);
    for (int k = 1; k < 20; ++k) {
      const Rational at(2 * k + 1, 41);
      CHECK(arcs_over(graph, at) == static_cast<int>(real_roots(f.at_r(at), 0, 1).size()));
    }
    CHECK(graph.components() == exchanged.components());
    CHECK(graph.isolated_points() == exchanged.isolated_points());
    CHECK(shape(graph).singular == shape(exchanged).singular);
  }
}

}  // namespace
}  // namespace exsect::curve_graph_test
