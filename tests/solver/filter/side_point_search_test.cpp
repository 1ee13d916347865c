#include "filter/side_point_search.h"

#include "filter/boundary.h"
#include "segment.h"

namespace exsect::side_point_search_test {
namespace {

using filter::Bicubic;
using filter::Vec4;
using testing::Segment;

}  // namespace

TEST_CASE("side point search: where boundary points are undecided it finds both ends, each once",
          "[filter]") {
  const Segment segment;
  filter::TreesOf<Bicubic> trees{filter::PatchTreeOf<Bicubic>(segment.pair.x),
                                 filter::PatchTreeOf<Bicubic>(segment.pair.y)};
  filter::ContactsOf<Bicubic> contacts;
  for (std::size_t found = 1; found <= 2; ++found) {
    const auto stuck = filter::undecided_on_sides<Bicubic>(segment.pair, trees, contacts);
    REQUIRE(stuck);
    REQUIRE(filter::add_side_point<Bicubic>(segment.x, segment.y, segment.pair, *stuck, contacts));
    CHECK(contacts.points.size() == found);
    CHECK_FALSE(filter::add_side_point<Bicubic>(segment.x, segment.y, segment.pair, *stuck, contacts));
    CHECK_FALSE(
        filter::add_side_double_point<Bicubic>(segment.x, segment.y, segment.pair, *stuck, 1e-6, contacts));
  }
  CHECK_FALSE(filter::undecided_on_sides<Bicubic>(segment.pair, trees, contacts));
  CHECK_FALSE(filter::add_corner_points<Bicubic>(segment.x, segment.y, segment.pair, contacts));
  long boxes = 0;
  const auto points = filter::boundary_points<Bicubic>(segment.pair, contacts, trees, boxes);
  REQUIRE(points);
  CHECK(points->size() == 2);
}

}  // namespace exsect::side_point_search_test
