#include "filter/path_contact.h"

#include "side_on_a_line.h"

namespace exsect::path_contact_test {
namespace {

using testing::OnInteriorLine;

}  // namespace

TEST_CASE("path contact: a side on an inner line, from end to end", "[filter]") {
  const OnInteriorLine on;
  CHECK_FALSE(on.path.of_x);
  CHECK(on.path.common.lower == 0);
  CHECK(on.path.common.upper == 1);
  for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1)})
    CHECK(on.path.at(t) == std::array<Rational, 4>{Rational(1, 2), t, 0, t});
  const filter::PathContact contact = filter::path_contact(on.path, on.pair);
  CHECK(contact.ends[0][0] == 0);
  CHECK(contact.ends[0][1] == -0.5);
  CHECK(contact.ends[1][0] == 0);
  CHECK(contact.ends[1][1] == 0.5);
  CHECK_FALSE(contact.side.reversed);
}

}  // namespace exsect::path_contact_test
