#include "filter/added_path.h"

#include "side_on_a_line.h"

namespace exsect::added_path_test {
namespace {

using filter::Biquadratic;
using testing::OnInteriorLine;

}  // namespace

TEST_CASE("added path: once, as a path of one patch", "[filter]") {
  const OnInteriorLine on;
  filter::Contacts contacts;
  for (int round = 0; round < 2; ++round) {
    filter::add_path<Biquadratic>(on.path, on.pair, contacts);
    CHECK(contacts.paths.size() == 1);
    CHECK(contacts.sides.empty());
  }
}

}  // namespace exsect::added_path_test
