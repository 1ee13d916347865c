#include "special/missed_plane.h"

#include "support/catch.h"
#include "support/families.h"

namespace exsect::missed_plane_test {

TEST_CASE("a plane that is missed, touched, crossed") {
  const Rational tiny = Rational(1) / pow(Integer(10), 40);
  for (const families::Plane plane : families::all_planes) {
    const auto decides = [&](const ExactCase& c) {
      const auto result = intersect_missed_plane(c.x, c.y);
      const auto other = intersect_missed_plane(c.y, c.x);
      CHECK(result.has_value() == other.has_value());
      if (result) CHECK((result->status == Status::complete && result->graph.nodes.empty()));
      return result.has_value();
    };
    CHECK(decides(families::cap(-tiny, plane)));
    CHECK(!decides(families::cap(0, plane)));
    CHECK(!decides(families::cap(tiny, plane)));
    CHECK(decides(families::parted_sheets(tiny, plane)));
    CHECK(!decides(families::near_sheets(tiny, plane)));
    CHECK(!decides(families::crossing(plane)));
    CHECK(!decides(families::tangent_curve(0, plane)));
  }
  const ExactCase curved = families::mirror_images();
  CHECK(!intersect_missed_plane(curved.x, curved.y));
  const ExactCase twice = families::coplanar_squares();
  CHECK(!intersect_missed_plane(twice.x, twice.y));
}

}  // namespace exsect::missed_plane_test
