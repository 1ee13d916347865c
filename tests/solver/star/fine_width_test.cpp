#include "star/fine_width.h"

#include "support/catch.h"

namespace exsect::fine_width_test {

TEST_CASE("fine width: two hundred halvings of the unit, exactly", "[star]") {
  Rational width = 1;
  for (int i = 0; i < 200; ++i) width /= 2;
  CHECK(fine_width() == width);
  CHECK(fine_width() > 0);  // of a double's square it would be rounding alone
}

}  // namespace exsect::fine_width_test
