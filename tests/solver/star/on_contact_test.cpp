#include "star/on_contact.h"

#include "side/boundary_lines.h"
#include "star_at_centre.h"
#include "support/bent_contact.h"
#include "support/families.h"

namespace exsect::on_contact_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the bent contact

/// How many of the boundary points are on a contact, at either precision.
struct OnContact {
  std::size_t boundary = 0, found = 0;

  OnContact(const BezierPatch& x, const BezierPatch& y) {
    ExactPair pair(x, y);
    const std::vector<CertifiedPoint> points = points_on_sides(x, y);
    const std::vector<bool> on_side_arc(points.size(), false);
    const std::vector<CertifiedPoint> pinches;
    const SingularPointQuery query = {pair, {points, Parameter::s, {}}, on_side_arc, pinches, 1e-6};
    const PairSystem<DoubleBall> doubles(x, y, Point{0, 0, 0}, 0);
    const PairSystem<ArbBall<256>> long_balls(x, y, Point{0, 0, 0}, 0);
    for (const CertifiedPoint& point : points) {
      const bool on = is_on_contact(query, doubles, point);
      CHECK(is_on_contact(query, long_balls, point) == on);
      ++boundary;
      if (on) ++found;
    }
  }
};

}  // namespace

TEST_CASE("on contact: the ends of a curve along which the patches touch, an irrational one too", "[star]") {
  const BentContact contact;
  const OnContact ends(contact.x, contact.y);
  CHECK(ends.boundary == 2);
  CHECK(ends.found == 2);
}

TEST_CASE("on contact: ends of transversal curves are not, nor is an isolated touch point", "[star]") {
  const OnContact hyperbola(graph_patch(kHyperbola), plane_patch());
  CHECK(hyperbola.boundary == 2);
  CHECK(hyperbola.found == 0);
  // u^2 + (v - 1/2)^2: the point (0, 1/2) on the side.
  const OnContact touch(graph(Terms{{{2, 0}, 1}} + kFromMiddleV * kFromMiddleV), plane_patch());
  CHECK(touch.boundary == 1);
  CHECK(touch.found == 0);
}

TEST_CASE("on contact: of two lines the one along which the patches touch", "[star]") {
  // a^2 b: along u = 1/2 they touch, along v = 1/2 they cross.
  const OnContact lines(graph(kFromMiddleU * kFromMiddleU * kFromMiddleV), plane_patch());
  CHECK(lines.boundary == 4);
  CHECK(lines.found == 2);
}

}  // namespace exsect::on_contact_test
