// Singular points of which no parameter is rational: exactly, and as nodes of the intersection.
#include "eliminant/algebraic_fibre.h"

#include <exsect/algebra/algebraic_value.h>
#include <exsect/solver/intersect.h>

#include <algorithm>

#include "eliminant/critical_values.h"
#include "support/catch.h"
#include "support/graph_checks.h"
#include "support/graph_isomorphism.h"
#include "support/graph_patches.h"
#include "support/random_pairs.h"
#include "support/renaming_checks.h"

namespace exsect::algebraic_fibre_test {
namespace {

using testing::graph;
using testing::Terms;

/// Added to the height of both patches: the plane patch becomes curved.
const Terms w = {{{1, 1}, 1}, {{2, 0}, Rational(1, 2)}, {{0, 2}, Rational(1, 3)}};

/// u v = 1/8 and u + v = 1 meet in (1 ± 1/√2)/2.
const Terms hyperbola = {{{1, 1}, 1}, {{0, 0}, Rational(-1, 8)}};
const Terms line = {{{1, 0}, 1}, {{0, 1}, 1}, {{0, 0}, -1}};
const Terms minus_one = {{{0, 0}, -1}};
const double kLow = 0.14644660940672624;
const double kHigh = 0.8535533905932738;

long count_kind(const IntersectionGraph& graph, NodeKind kind) {
  return std::count_if(graph.nodes.begin(), graph.nodes.end(), [&](const Node& node) {
    return std::count(node.kinds.begin(), node.kinds.end(), kind) > 0;
  });
}

void check_nodes(const IntersectionGraph& graph, NodeKind kind) {
  CHECK(count_kind(graph, kind) == 2);
  for (const Node& node : graph.nodes) {
    if (std::count(node.kinds.begin(), node.kinds.end(), kind) == 0) continue;
    const double u = node.approx[0] < 0.5 ? kLow : kHigh;
    CHECK(node.approx[0] == Approx(u).epsilon(1e-14));
    CHECK(node.approx[1] == Approx(1 - u).epsilon(1e-14));
    CHECK(node.box[0].width() < power_of_two(-40));
    // 8 t² - 8 t + 1 = 0
    const auto f = [](const Rational& t) { return Rational(8 * t * t - 8 * t + 1); };
    CHECK(f(node.box[0].lower) * f(node.box[0].upper) <= 0);
  }
}

}  // namespace

TEST_CASE("singular points over an algebraic value are found exactly") {
  const BezierPatch x = graph(hyperbola * line + w);
  const BezierPatch y = graph(w);
  const std::vector<RealAlgebraic> values = real_roots(Polynomial({1, -8, 8}), 0, 1);
  REQUIRE(values.size() == 2);
  for (const Parameter sweep : all_parameters) {
    const auto found = singular_points_over(x, y, sweep, values[0]);
    REQUIRE(found.size() == 1);
    const auto exact = found[0].at.exact();
    REQUIRE(exact);
    for (const std::size_t j : {0U, 2U}) {  // the other parameter of the patch is one minus this
      const BivariatePolynomial difference = exact->numerator[j] * exact->denominator[j + 1] +
                                             exact->numerator[j + 1] * exact->denominator[j] -
                                             exact->denominator[j] * exact->denominator[j + 1];
      CHECK(sign_at(difference, exact->at) == 0);
    }
    const ParameterBox fine = found[0].at.refined_to(power_of_two(-300)).box();
    for (const RationalInterval& side : fine) CHECK(side.width() <= power_of_two(-300));
    ParameterBox box;
    for (std::size_t j = 0; j < 4; ++j) {
      const Rational middle = fine[j].midpoint();
      box[j] = {middle - power_of_two(-8), middle + power_of_two(-8)};
    }
    CHECK(found[0].is_alone_in(box));
    box[index(found[0].kept)].lower = box[index(found[0].kept)].upper - power_of_two(-12);
    CHECK_FALSE(found[0].is_alone_in(box));
  }
  // A turning point is none, nor is a simple point.
  CHECK(singular_points_over(x, y, Parameter::u, real_roots(Polynomial({-1, 0, 2}), 0, 1)[0]).empty());
}

TEST_CASE("points of a common side are not inside") {
  // Where the tangent planes agree along u = r = 0, over a value of v of degree 5, each projection of the
  // fibre has a double root, but no point is inside.
  random_pairs::Generator generator(5);
  const auto number = [&] { return Rational(random_pairs::integer(generator, -16, 16), 16); };
  ControlNet first, second;
  for (ControlNet* net : {&first, &second})
    for (auto& row : *net)
      for (Point& p : row) p = {number(), number(), number()};
  second[0] = first[0];
  const BezierPatch x(first);
  const BezierPatch y(second);
  const auto turning = turning_values(x, y, Parameter::v);
  REQUIRE(turning);
  int found = 0;
  for (const TurningValue& value : turning->values) {
    if (value.multiplicity != 2 || value.value.is_rational()) continue;
    CHECK(value.value.polynomial().degree() == 5);
    CHECK(singular_points_over(x, y, Parameter::v, value.value).empty());
    ++found;
  }
  CHECK(found > 0);
}

TEST_CASE("touch points and crossings that are irrational in all parameters") {
  const std::pair<Terms, NodeKind> members[] = {
      {hyperbola * hyperbola + line * line, NodeKind::touch},
      {hyperbola * line, NodeKind::crossing},
      {hyperbola * hyperbola + minus_one * line * line, NodeKind::crossing}};
  for (const auto& [h, kind] : members) {
    for (const bool curved : {false, true}) {
      const BezierPatch x = graph(curved ? h + w : h);
      const BezierPatch y = graph(curved ? w : Terms{});
      const IntersectResult result = complete_intersection(x, y);
      check_nodes(result.graph, kind);
      CHECK(result.graph.isolated_points.size() == (kind == NodeKind::touch ? 2U : 0U));
    }
  }
}

TEST_CASE("irrational crossings keep under exchange, reversal and affine maps") {
  random_pairs::Generator generator(9);
  const BezierPatch x = graph(hyperbola * line + w);
  const BezierPatch y = graph(w);
  const IntersectResult result = complete_intersection(x, y);
  CHECK(difference(result.graph, complete_intersection(y, x).graph, {{2, 3, 0, 1}, {}}, 1e-3) == "");
  CHECK(difference(result.graph, complete_intersection(x.exchanged(), y).graph, {{1, 0, 2, 3}, {}}, 1e-3) ==
        "");
  CHECK(difference(result.graph, complete_intersection(x, y.reversed_second()).graph,
                   {{0, 1, 2, 3}, {false, false, false, true}}, 1e-3) == "");
  const random_pairs::AffineMap map = random_pairs::affine_map(generator);
  CHECK(difference(result.graph, complete_intersection(map(x), map(y)).graph, {{0, 1, 2, 3}, {}}, 1e-3) ==
        "");
}

}  // namespace exsect::algebraic_fibre_test
