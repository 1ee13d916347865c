// Vertices between two nodes against the curve of two cylinders, which is known: along the narrow one about
// x, of radius 1, x = sqrt(4 - cos^2 a) at the angle a; and against Newton's method on a torus.
#include "filter/round_vertices.h"

#include <cmath>

#include "filter/round_trace.h"
#include "support/catch.h"

namespace exsect::round_vertices_test {
namespace {

using S = ImplicitSurface;

RoundNode node(const RoundTube& tube, double s, double reach) {
  const NearCurve near = near_curve(tube, s, tube.slope * s, 1e-13);
  return {s, near, arc_near(tube, near, reach)};
}

double apart(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], std::hypot(a[1] - b[1], a[2] - b[2]));
}

/// The vertices are where near_curve says that the curve is.
void check(const RoundPart& part, const RoundTube& tube, double from, double to, int count, double most) {
  ArcPolyline line;
  part.add_vertices(count, line);
  const double bound = line.bound();
  CHECK(bound <= most);
  REQUIRE(line.size() == static_cast<std::size_t>(count - 1));
  int i = 0;
  for (const PolylineVertex& vertex : line.take_vertices()) {
    const double s = from + (to - from) * ++i / count;
    const auto [x, y, z] = tube.chart->position({near_curve(tube, s, tube.slope * s, 1e-14).place, {}});
    CHECK(apart(vertex.point, {x.approximation(), y.approximation(), z.approximation()}) <=
          bound / 2 + 1e-13);
  }
}

}  // namespace

TEST_CASE("round vertices: on the curve of two cylinders") {
  const RoundChart chart =
      RoundChart::of(S::cylinder({0, 0, 0}, {1, 0, 0}, 1), S::cylinder({0, 0, 0}, {0, 0, 1}, 2)).value();
  RoundPlace place{{turned({1, 0}, 0.4), RoundCoordinate{0, 0}}};
  const double at = chart.position({place, {}})[1].approximation();
  place.at[1][0] = std::sqrt(4 - at * at) / chart.unit();
  const RoundTube tube = round_tube(chart, place, 0, 0.1).value();
  const RoundNode a = node(tube, -0.06, 0.06), b = node(tube, 0.05, 0.06);
  ArcPolyline line;
  RoundPart(tube, a, b, 1e-9).add_vertices(8, line);
  CHECK(line.bound() < 1e-8);
  const double bound = line.bound() / 2 + 1e-15;
  for (const PolylineVertex& vertex : line.take_vertices()) {
    const auto& [x, y, z] = vertex.point;
    CHECK(std::fabs(y * y + z * z - 1) <= 2.1 * bound);
    CHECK(std::fabs(x * x + y * y - 4) <= 4.1 * bound);
  }
}

TEST_CASE("round vertices: as by Newton's method, in odd and even numbers, both ways, for all charts") {
  const S torus = S::torus({0, 0, 0}, {1, 2, 3}, 3, 1),
          narrow = S::cylinder({Rational(1, 5), 0, 0}, {1, 1, 0}, 1);
  for (const auto& [first, second] : {std::pair(S::cylinder({0, 0, 0}, {0, 0, 1}, 2), narrow),
                                      {torus, narrow},
                                      {torus, S::torus({2, 0, 0}, {0, 0, 1}, 2, Rational(3, 4))},
                                      {S::cone({0, 0, 4}, {0, 0, -1}, Rational(1, 3)), narrow}}) {
    const RoundChart chart = RoundChart::of(first, second).value();
    const auto trace = round_trace(chart, round_landmarks(chart).value(), 0).value();
    for (const auto& [tube, range] : trace.pieces) {
      const double from = range.from(), to = range.to(), half = std::fabs(to - from) / 2;
      for (const int count : {1, 2, 5, 8}) {
        check(RoundPart(tube, node(tube, from, half), node(tube, to, half), 1e-7), tube, from, to, count,
              1e-5);
        check(RoundPart(tube, node(tube, to, half), node(tube, from, half), 1e-12), tube, to, from, count,
              1e-9);
      }
      // Nodes that mislead: Newton's method is left.
      RoundNode a = node(tube, from, half);
      a.arc.slope = std::nan("");
      check(RoundPart(tube, a, node(tube, to, half), 1e-9), tube, from, to, 3, 1e-7);
      a.arc.slope = 1e3;
      check(RoundPart(tube, a, node(tube, to, half), 1e-9), tube, from, to, 3, 1e-7);
    }
  }
}

}  // namespace exsect::round_vertices_test
