#include "star/star_neighbourhood.h"

#include "answer/parameter_box.h"
#include "line/half_rational_point.h"
#include "star_at_centre.h"

namespace exsect::star_neighbourhood_test {

namespace {

const Rational half(1, 2);

/// a = u - 1/2 and b = v - 1/2 as polynomials; h = sum of coefficient a^i b^j.
struct Term {
  Rational coefficient;
  int i;
  int j;
};

}  // namespace

TEST_CASE("stars: as many arcs as branches meet at the point", "[star]") {
  struct Example {
    const char* name;
    std::vector<Term> h;
    Parameter sweep;
    std::size_t below;  // ports at smaller values of the sweep parameter
    std::size_t above;
  };
  const std::vector<Example> examples = {
      {"touch", {{1, 2, 0}, {1, 0, 2}}, Parameter::u, 0, 0},
      {"crossing", {{1, 2, 0}, {-1, 0, 2}}, Parameter::u, 2, 2},
      {"crossing, unequal", {{1, 2, 0}, {3, 1, 1}, {-5, 0, 2}}, Parameter::v, 2, 2},
      {"cusp", {{1, 2, 0}, {-2, 1, 1}, {1, 0, 2}, {-1, 2, 1}}, Parameter::u, 0, 2},
      {"cusp across", {{1, 2, 0}, {-2, 1, 1}, {1, 0, 2}, {-1, 2, 1}}, Parameter::v, 0, 2},
      {"two branches tangent", {{1, 2, 0}, {-1, 1, 2}}, Parameter::v, 2, 2},
      {"tangent to a parabola", {{1, 2, 0}, {-1, 0, 2}, {1, 2, 1}}, Parameter::u, 2, 2},
  };
  for (const Example& e : examples) {
    INFO(e.name);
    testing::HeightCoefficients h{};
    for (const Term& t : e.h) {
      // (u - 1/2)^i (v - 1/2)^j
      const std::array<std::array<Rational, 3>, 3> power = {
          {{1, 0, 0}, {-half, 1, 0}, {Rational(1, 4), -1, 1}}};
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          h[i][j] += t.coefficient * power[static_cast<std::size_t>(t.i)][i] *
                     power[static_cast<std::size_t>(t.j)][j];
        }
      }
    }
    const BezierPatch x = testing::graph_patch(h);
    const BezierPatch y = testing::plane_patch();
    for (const double halfwidth : {0.03125, 0x1p-20}) {
      auto star = testing::star_at_centre(x, y, e.sweep, halfwidth);
      REQUIRE(star);
      std::size_t below = 0;
      for (const Port& port : star->ports) {
        below += port.side < 0 ? 1U : 0U;
        CHECK(lies_in(port.point.box(), star->box));
      }
      CHECK(below == e.below);
      CHECK(star->ports.size() - below == e.above);
      add_layers(*star, x, y, half, 3);
      CHECK(star->layers[0].size() == (e.below > 0 ? 3 : 0));
      CHECK(star->layers[1].size() == (e.above > 0 ? 3 : 0));
    }
  }
}

TEST_CASE("stars: a real isolated point of a line's complex curve is not on the line", "[star]") {
  // y = (1/2 + (p - q)/2, f, 2 f) with p = r - 1/2, q = s - 1/2, f = p^2 + q^2 - 4 p q (p + q): f = 0 is a
  // branch through p = q = 1/4 and the isolated point p = q = 0. The line u = 1/3 of the plane x lies on y
  // along the branch, and has the same point of space, v = 1/2, over both.
  using testing::Terms;
  const Terms p = {{{1, 0}, 1}, {{0, 0}, -half}};
  const Terms q = {{{0, 1}, 1}, {{0, 0}, -half}};
  const Terms four = {{{0, 0}, -4}};
  const Terms f = p * p + q * q + four * p * q * (p + q);
  ControlNet c{};
  for (const auto& [i, a] : f) c[i.first][i.second] = Point{Rational(0), a, 2 * a};
  c[0][0][0] = half;
  c[1][0][0] += half;
  c[0][1][0] -= half;
  const BezierPatch y = BezierPatch::from_power_basis(c);
  const BezierPatch x = testing::plane({0, Rational(-1, 3), Rational(-5, 3)}, {0, 1, 5}, {1, 0, 0});
  ExactPair pair(x, y);
  const auto& turning = pair.turning(Parameter::u);
  REQUIRE(turning);
  const std::vector<CertifiedPoint> boundary = testing::points_on_sides(x, y);
  const StarPlaces places = {boundary, Parameter::s, {}};
  int centres = 0;
  for (const double halfwidth : {0.5, 0.25, 0x1p-4}) {
    StarQuery query = {pair, places, *turning, halfwidth};
    query.along = RealAlgebraic(half);
    for (const HalfRationalPoint& point : half_rational_points(x, y, true, {Rational(1, 3), half})) {
      ++centres;
      const ParameterBox at = point.point.box();
      const auto star = star_neighbourhood(query, point.point, Rational(1, 3));
      if (!star) continue;
      const Rational other = at[2].upper < Rational(5, 8) ? Rational(3, 4) : half;
      const bool holds_other = star->box[2].lower <= other && other <= star->box[2].upper;
      CHECK_FALSE(holds_other);
      CHECK(star->ports.size() == (other == half ? 2 : 0));
    }
  }
  CHECK(centres == 6);
}

}  // namespace exsect::star_neighbourhood_test
