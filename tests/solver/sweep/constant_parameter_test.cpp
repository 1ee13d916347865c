// Curves on which a parameter has a constant value that is not rational.
#include "sweep/constant_parameter.h"

#include <exsect/solver/intersect.h>

#include <algorithm>

#include "support/catch.h"
#include "support/graph_checks.h"
#include "support/graph_patches.h"
#include "swept_pair.h"

namespace exsect::constant_parameter_test {
namespace {

BezierPatch graph(const testing::HeightCoefficients& h) { return testing::graph_patch(h); }

/// One open arc with u = sqrt(value) throughout, and no turning points.
void check_line(const BezierPatch& x, const BezierPatch& y, const Rational& value) {
  const IntersectResult result = intersect(x, y);
  for (const Incomplete& region : result.incomplete) UNSCOPED_INFO(region.why);
  CHECK(result.status == Status::complete);
  CHECK(unsound(x, y, result) == "");
  REQUIRE(result.graph.arcs.size() == 1);
  for (const PolylineVertex& vertex : result.graph.arcs[0].polyline)
    CHECK(vertex.parameters[0] * vertex.parameters[0] == Approx(to_double(value)).epsilon(1e-13));
  for (const Node& node : result.graph.nodes) CHECK(node.wrt.empty());
}

}  // namespace

TEST_CASE("a parameter line over an irrational value lies on the other patch") {
  // (u, v, u² - 1/2 + h) and (r, s, h) over the line u = 1/√2
  const Rational zero = 0;
  testing::HeightCoefficients square{};
  square[0][0] = Rational(-1, 2);
  square[2][0] = 1;
  check_line(graph(square), testing::plane_patch(), Rational(1, 2));
  testing::HeightCoefficients base{};
  base[1][1] = 1;
  base[0][2] = Rational(1, 3);
  testing::HeightCoefficients sum = base;
  sum[0][0] = Rational(-1, 3);
  sum[2][0] = 1;
  check_line(graph(sum), graph(base), Rational(1, 3));
  // A plane across the parameters.
  check_line(graph(square),
             testing::plane({Rational(-1, 8), Rational(-1, 8), zero}, {Rational(5, 4), Rational(1, 7), zero},
                            {Rational(1, 9), Rational(5, 4), zero}),
             Rational(1, 2));
}

TEST_CASE("a parameter line over an irrational value crosses another curve") {
  // (u, v, (u - u² - 1/8) (v - 1/2) + h) and (r, s, h): the lines u = 1/2 ± 1/√8 and v = 1/2.
  testing::HeightCoefficients base{};
  base[2][0] = Rational(1, 3);
  base[0][2] = Rational(-1, 5);
  base[1][1] = Rational(1, 7);
  base[2][2] = Rational(1, 2);
  base[1][0] = Rational(1, 4);
  testing::HeightCoefficients sum = base;
  const std::array<Rational, 3> in_u = {Rational(-1, 8), 1, -1};
  for (std::size_t i = 0; i < 3; ++i) {
    sum[i][0] -= in_u[i] / 2;
    sum[i][1] += in_u[i];
  }
  for (const bool exchanged : {false, true}) {
    const BezierPatch x = exchanged ? graph(sum).exchanged() : graph(sum);
    const IntersectResult result = intersect(x, graph(base));
    for (const Incomplete& region : result.incomplete) UNSCOPED_INFO(region.why);
    CHECK(result.status == Status::complete);
    CHECK(unsound(x, graph(base), result) == "");
    CHECK(result.graph.nodes.size() == 8);
    CHECK(result.graph.arcs.size() == 7);
  }
}

TEST_CASE("a nearly constant parameter turns or not, but is not constant") {
  // u² - 1/2 = 10^-9 (v - 1/3)²: u has one turning point
  testing::HeightCoefficients h{};
  const Rational small(1, 1000000000);
  h[0][0] = Rational(-1, 2) - small / 9;
  h[0][1] = small * Rational(2, 3);
  h[0][2] = -small;
  h[2][0] = 1;
  const IntersectResult result = intersect(graph(h), testing::plane_patch());
  CHECK(result.status == Status::complete);
  CHECK(std::count_if(result.graph.nodes.begin(), result.graph.nodes.end(), [](const Node& node) {
          return std::count(node.wrt.begin(), node.wrt.end(), Parameter::u) > 0;
        }) == 1);
}

TEST_CASE("points with a value on a line: all of them, of a patch that covers the line twice too") {
  // (u, v, 0) and (4 (r - 1/2)^2, s, s - 1/2): v = 1/2, with r and 1 - r over each u.
  ControlNet power{};
  power[0][0] = {1, 0, Rational(-1, 2)};
  power[1][0] = {-4, 0, 0};
  power[2][0] = {4, 0, 0};
  power[0][1] = {0, 1, 1};
  testing::SweptPair pair(testing::plane_patch(), BezierPatch::from_power_basis(power));
  const auto at = [&](const Rational& u, const Rational& v) {
    return points_with_value(pair.data, {Parameter::u, u}, Parameter::v, v)->size();
  };
  CHECK(at(Rational(1, 4), Rational(1, 2)) == 2);
  CHECK(at(Rational(1, 4), Rational(1, 2) + power_of_two(-90)) == 0);
  CHECK(at(0, Rational(1, 2)) == 1);  // where the other patch folds
  // All of v = 1/2 lies on it.
  CHECK_FALSE(points_with_value(pair.data, {Parameter::v, Rational(1, 2)}, Parameter::u, Rational(1, 4)));
}

}  // namespace exsect::constant_parameter_test
