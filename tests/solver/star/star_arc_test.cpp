#include "star/star_arc.h"

#include <algorithm>

#include "answer/parameter_box.h"
#include "star/singular_points.h"
#include "star_at_centre.h"

namespace exsect::star_arc_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the star in the middle

const Rational half(1, 2);
const Terms& a = kFromMiddleU;
const Terms& b = kFromMiddleV;
const Terms minus = {{{0, 0}, -1}};

StarNeighbourhood star_of(const Terms& h, Parameter sweep) {
  const BezierPatch x = graph(h), y = plane_patch();
  auto star = star_at_centre(x, y, sweep, 0x1p-6);
  REQUIRE(star);
  REQUIRE(add_layers(*star, x, y, half, 4));
  return *std::move(star);
}

bool is_in_some(const std::vector<ParameterBox>& hulls, const std::array<Rational, 4>& w) {
  return std::any_of(hulls.begin(), hulls.end(), [&](const ParameterBox& hull) {
    for (std::size_t j = 0; j < 4; ++j)
      if (w[j] < hull[j].lower || w[j] > hull[j].upper) return false;
    return true;
  });
}

}  // namespace

TEST_CASE("star arc: the arcs of a crossing stay in their hulls, and its vertices are on them", "[star]") {
  // a^2 = b^2: the lines b = a and b = -a.
  const StarNeighbourhood star = star_of(a * a + minus * b * b, Parameter::u);
  REQUIRE(star.ports.size() == 4);
  for (const Port& port : star.ports) {
    const StarArc arc = star_arc(star, port);
    CHECK(arc.vertices.size() == 4);
    CHECK(arc.hulls.size() == 5);
    const ParameterBox at = port.point.box();
    const int slope = (at[0].midpoint() > half) == (at[1].midpoint() > half) ? 1 : -1;
    const Rational reach = at[0].midpoint() - half;
    for (int i = 0; i <= 64; ++i) {
      const Rational t = reach * i / 64, u = half + t, v = half + slope * t;
      CHECK(is_in_some(arc.hulls, {u, v, u, v}));
    }
    for (const CertifiedPoint& vertex : arc.vertices) {
      const ParameterBox box = vertex.box();
      const Rational u = box[0].midpoint() - half, v = box[1].midpoint() - half;
      CHECK(abs(abs(u) - abs(v)) <= box[0].width() + box[1].width());
      CHECK(abs(u) < abs(reach));  // from the port inwards
    }
  }
}

TEST_CASE("star arc: across another parameter than the swept one there is one hull", "[star]") {
  // a b: of the two lines one is swept over at once.
  const BezierPatch x = graph(a * b), y = plane_patch();
  ExactPair pair(x, y);
  const std::vector<CertifiedPoint> points = points_on_sides(x, y), pinches;
  const std::vector<bool> on_side_arc(points.size(), false);
  const SingularPointQuery query = {pair, {points, Parameter::v, {}}, on_side_arc, pinches, 1e-6};
  const auto stars = singular_stars(query, PairSystem<DoubleBall>(x, y, Point{0, 0, 0}, 0));
  REQUIRE(stars.size() == 1);
  const StarNeighbourhood& star = stars[0];
  REQUIRE(star.ports.size() == 4);
  int across = 0;
  for (const Port& port : star.ports) {
    if (port.across == star.sweep) continue;
    ++across;
    const StarArc arc = star_arc(star, port);
    CHECK(arc.vertices.empty());
    REQUIRE(arc.hulls.size() == 1);
    const ParameterBox at = port.point.box();
    // On the line all points between the port and the centre are on the arc.
    const Rational u = (at[0].midpoint() + half) / 2, v = (at[1].midpoint() + half) / 2;
    CHECK(is_in_some(arc.hulls, {u, v, u, v}));
  }
  CHECK(across == 2);
}

TEST_CASE("star arc: what turns in a cusp, and what does not", "[star]") {
  // (a - b)^2 = a^3 in the middle: both arcs go to a > 0, b > 0. (The cube is a^2 b, as b = a there.)
  const Terms cusp = a * a + Terms{{{0, 0}, -2}} * a * b + b * b + minus * a * a * b;
  const auto turning = turning_parameters(star_of(cusp, Parameter::u));
  REQUIRE(turning);
  CHECK(*turning == std::vector<Parameter>{Parameter::u, Parameter::v, Parameter::r, Parameter::s});
}

}  // namespace exsect::star_arc_test
