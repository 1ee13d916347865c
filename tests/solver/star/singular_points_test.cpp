#include "star/singular_points.h"

#include "answer/parameter_box.h"
#include "star_at_centre.h"
#include "support/known_curves.h"

namespace exsect::singular_points_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

std::vector<StarNeighbourhood> stars_of(const BezierPatch& x, const BezierPatch& y,
                                        const StopRequest& stop = {}) {
  ExactPair pair(x, y, stop);
  const std::vector<CertifiedPoint> points = points_on_sides(x, y);
  const std::vector<bool> on_side_arc(points.size(), false);
  const std::vector<CertifiedPoint> pinches;
  const SingularPointQuery query = {pair, {points, Parameter::u, {}}, on_side_arc, pinches, 1e-6};
  return singular_stars(query, PairSystem<DoubleBall>(x, y, Point{0, 0, 0}, 0));
}

const Terms& a = kFromMiddleU;
const Terms& b = kFromMiddleV;

Terms scaled(const Rational& factor, const Terms& h) { return Terms{{{0, 0}, factor}} * h; }

}  // namespace

TEST_CASE("singular points: none of curves without any", "[star]") {
  CHECK(stars_of(graph_patch(kCircle), plane_patch()).empty());
  CHECK(stars_of(graph_patch(kHyperbola), plane_patch()).empty());
}

TEST_CASE("singular points: a crossing, a touch point and a node of a cubic, each once", "[star]") {
  struct Example {
    Terms h;
    std::size_t ports;
  };
  for (const Example& e : {Example{a * a + scaled(-3, b * b), 4}, Example{a * a + scaled(2, b * b), 0},
                           Example{a * a + scaled(-1, b * b) + a * a * b, 4}}) {
    const auto stars = stars_of(graph(e.h), plane_patch());
    REQUIRE(stars.size() == 1);
    CHECK(stars[0].ports.size() == e.ports);
    CHECK(is_singular(stars[0]) == (e.ports >= 3));
    REQUIRE(stars[0].outer);
    CHECK(lies_in(stars[0].box, *stars[0].outer));
    for (const RationalInterval& at : stars[0].centre.box()) {
      CHECK(at.lower <= q(1, 2));
      CHECK(q(1, 2) <= at.upper);
    }
  }
}

TEST_CASE("singular points: a curve that is tangent to a side needs a star there", "[star]") {
  // v = (u - 1/2)^2 touches the side v = 0.
  const auto stars = stars_of(graph(Terms{{{0, 1}, 1}} + scaled(-1, a * a)), plane_patch());
  REQUIRE(stars.size() == 1);
  CHECK(stars[0].ports.size() == 2);
  CHECK_FALSE(is_singular(stars[0]));
}

TEST_CASE("singular points: near misses of a crossing have none, beside each other two", "[star]") {
  for (const int digits : {3, 6, 12}) {
    Rational e = 1;
    for (int i = 0; i < digits; ++i) e /= 10;
    CAPTURE(digits);
    CHECK(stars_of(graph(a * a + scaled(-3, b * b) + Terms{{{0, 0}, e}}), plane_patch()).empty());
    CHECK(stars_of(graph(a * a + scaled(2, b * b) + Terms{{{0, 0}, e}}), plane_patch()).empty());
  }
}

TEST_CASE("singular points: after a stop what was found is all", "[star]") {
  CHECK(stars_of(graph(a * a + scaled(-3, b * b)), plane_patch(), [] { return true; }).empty());
}

}  // namespace exsect::singular_points_test
