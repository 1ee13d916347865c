#include "star/star_neighbourhood.h"

#include <exsect/solver/line_patch.h>

#include "answer/parameter_box.h"
#include "support/catch.h"
#include "support/graph_patches.h"

namespace exsect::star_neighbourhood_test {

namespace {

const Rational half(1, 2);

/// The star of G[h] and the plane at u = v = 1/2, where both sweeps have a turning value.
std::optional<StarNeighbourhood> star_at_centre(const BezierPatch& x, const BezierPatch& y, Parameter sweep,
                                                double halfwidth) {
  ExactPair pair(x, y);
  const auto& turning = pair.turning(sweep);
  REQUIRE(turning);
  std::vector<CertifiedPoint> boundary;
  for (const Parameter p : all_parameters) {
    for (const int value : {0, 1}) {
      for (const CertifiedPoint& point : line_points(x, y, {p, value}).points) {
        if (point.sides().front() == Side{p, value}) {
          boundary.push_back(point);
        }
      }
    }
  }
  const StarPlaces places = {boundary, Parameter::s, {}};
  const StarQuery query = {pair, places, *turning, halfwidth};
  for (const CertifiedPoint& point : line_points(x, y, {sweep, half}).points) {
    const ParameterBox box = point.box();
    if (box[0].lower <= half && half <= box[0].upper && box[1].lower <= half && half <= box[1].upper) {
      return star_neighbourhood(query, point, half);
    }
  }
  return std::nullopt;
}

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
      auto star = star_at_centre(x, y, e.sweep, halfwidth);
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

}  // namespace exsect::star_neighbourhood_test
