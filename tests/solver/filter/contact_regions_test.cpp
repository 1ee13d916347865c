#include "filter/contact_regions.h"

#include "support/catch.h"
#include "support/families.h"

namespace exsect::contact_regions_test {
namespace {

SearchRegion region(const std::array<double, 4>& lower, const std::array<double, 4>& upper) {
  return {lower, upper};
}

}  // namespace

TEST_CASE("contact regions: along a shared side all solutions are on it", "[filter]") {
  const ExactCase c = families::shared_side({0, 1, 0});
  const ContactRegions contacts(c.x, c.y);
  int settled = 0;
  for (int i = 0; i < 16; ++i) {
    const double at = i / 16.0, next = (i + 1) / 16.0;
    if (contacts.settles(region({0, at, 0, at}, {1.0 / 64, next, 1.0 / 64, next}))) ++settled;
  }
  CHECK(settled == 16);
}

TEST_CASE("contact regions: without contacts, or away from them, nothing is settled", "[filter]") {
  const ExactCase c = families::side_and_arc();
  CHECK_FALSE(ContactRegions(c.x, c.y).settles(region({0, 0, 0, 0}, {1, 1, 1, 1})));
  const ExactCase crossing = families::crossing(families::Plane::square);
  const ContactRegions none(crossing.x, crossing.y);
  CHECK_FALSE(none.settles(region({0.49, 0.49, 0.49, 0.49}, {0.51, 0.51, 0.51, 0.51})));
}

}  // namespace exsect::contact_regions_test
