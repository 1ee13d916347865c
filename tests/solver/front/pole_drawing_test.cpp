// Arcs that begin in a pole, drawn: an octant's meridians and a slanted section against their equations.
#include "pole_drawing.h"

#include <cmath>

#include "support/catch.h"

namespace exsect::pole_drawing_test {
namespace {

/// An octant of the unit sphere about the origin; the side u = 0 is its pole (0,0,1).
RationalPatch octant() {
  return RationalPatch({{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
                        {{1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                        {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
                       {{1, 1, 2}, {1, 1, 2}, {2, 2, 4}});
}

/// x = 2 y + slope (1 - z), around the pole.
PolePair pair_with(const Rational& slope) {
  const auto at = [&](const Rational& y, const Rational& z) -> Point {
    return {2 * y + slope * (1 - z), y, z};
  };
  const Rational low(-1, 3), high(2, 3), below(1, 2), above(7, 5);
  const RationalPatch sheet({{at(low, below), at(low, above)}, {at(high, below), at(high, above)}});
  const RationalPatch x = octant();
  const auto pole = pole_on_patch(x, sheet);
  REQUIRE(pole);
  const auto near_pole = [x, sheet, place = *pole](const Rational& reach,
                                                   const std::vector<Parameter>& turning) {
    return arcs_at_pole(x, sheet, place, reach, turning);
  };
  return {x, sheet, *pole, 1, near_pole};
}

PoleNeighbourhood neighbourhood(const PolePair& pair) {
  const Rational reach(1, 16);
  auto arcs = pair.near_pole(reach, {});
  REQUIRE(arcs);
  REQUIRE(arcs->size() == 1);
  return {reach, *std::move(arcs)};
}

/// Of the section over a = 1/16, moved by `off`.
PolylineVertex end_of(const PolePair& pair, double off) {
  PolylineVertex vertex{};
  const double a = 1.0 / 16, z = (1 - a * a) / (1 + a * a), out = std::sqrt(1 - z * z);
  const double slope = to_double(pair.y(0, 0)[0] - 2 * pair.y(0, 0)[1]) * 2;
  // x = 2 y + slope (1 - z), x^2 + y^2 = out^2.
  const double c = slope * (1 - z), y = (-2 * c + std::sqrt(4 * c * c + 5 * (out * out - c * c))) / 5;
  vertex.point = {2 * y + c + off, y, z};
  vertex.parameters = {a, std::tan(0.5 * std::atan2(y, 2 * y + c)), 0, 0};
  return vertex;
}

/// The distance of a point from the sphere, and from the plane.
double off_section(const std::array<double, 3>& p, double slope) {
  return std::max(std::abs(std::hypot(p[0], p[1], p[2]) - 1),
                  std::abs(p[0] - 2 * p[1] - slope * (1 - p[2])) / std::sqrt(5 + slope * slope));
}

}  // namespace

TEST_CASE("pole_drawing: arcs are drawn within the tolerance, and their bound holds") {
  for (const Rational& slope : {Rational(0), Rational(3, 2), Rational(-1)}) {
    const PolePair pair = pair_with(slope);
    std::size_t vertices = 0;
    for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
      INFO("slope " << to_double(slope) << ", tolerance " << tolerance);
      const Run run = Run().with_tolerance(tolerance);
      const Arc arc = PoleDrawing(pair, neighbourhood(pair), run).arc(0, end_of(pair, 0));
      CHECK(arc.error_bound <= tolerance);
      CHECK(arc.polyline.size() > vertices);
      vertices = arc.polyline.size();
      CHECK(arc.polyline.front().point == std::array<double, 3>{0, 0, 1});
      CHECK(arc.polyline.back().point == end_of(pair, 0).point);
      for (std::size_t i = 1; i < arc.polyline.size(); ++i) {
        const PolylineVertex &from = arc.polyline[i - 1], &to = arc.polyline[i];
        CHECK(from.parameters[0] < to.parameters[0]);
        std::array<double, 3> middle{};
        for (std::size_t c = 0; c < 3; ++c) middle[c] = (from.point[c] + to.point[c]) / 2;
        CHECK(off_section(middle, to_double(slope)) <= arc.error_bound + 1e-15);
        CHECK(off_section(to.point, to_double(slope)) <= arc.error_bound + 1e-15);
      }
    }
  }
}

TEST_CASE("pole_drawing: the bound covers the chord, and an end that is off the arc") {
  const PolePair pair = pair_with(0);
  for (const double off : {0.0, 1e-4, 1e-2}) {
    const Run run = Run().with_tolerance(1);
    const Arc arc = PoleDrawing(pair, neighbourhood(pair), run).arc(0, end_of(pair, off));
    REQUIRE(arc.polyline.size() == 2);
    CHECK(arc.error_bound < 0.02 + 2 * off);
    // The arc over a is at the angle 2 atan a of the meridian; the chord is parameterised by a as well.
    for (const double a : {0.01, 0.03, 0.05, 0.0625}) {
      const double z = (1 - a * a) / (1 + a * a), out = 2 * a / (1 + a * a);
      const std::array<double, 3> p = {out * 2 / std::sqrt(5.0), out / std::sqrt(5.0), z};
      double squares = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const double on = arc.polyline[0].point[c] * (1 - 16 * a) + arc.polyline[1].point[c] * 16 * a;
        squares += (on - p[c]) * (on - p[c]);
      }
      CHECK(std::sqrt(squares) <= arc.error_bound);
    }
  }
}

TEST_CASE("pole_drawing: the pole's node has the parameter along its side free") {
  const PolePair pair = pair_with(1);
  const Run run;
  const Node node = PoleDrawing(pair, neighbourhood(pair), run).node();
  CHECK(node.free == std::vector{Parameter::v});
  CHECK(node.on == std::vector<Side>{{Parameter::u, 0}});
  CHECK(node.box[2].lower == pair.pole.at[0].lower);
  CHECK(node.point == std::array<double, 3>{0, 0, 1});
}

}  // namespace exsect::pole_drawing_test
