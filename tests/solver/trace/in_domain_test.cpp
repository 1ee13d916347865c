#include "trace/in_domain.h"

#include "support/catch.h"

namespace exsect::in_domain_test {
namespace {

const Rational quarter(1, 4);

void check(const RationalInterval& at, const Rational& lower, const Rational& upper) {
  const RationalInterval inside = in_domain(at);
  CHECK(inside.lower == lower);
  CHECK(inside.upper == upper);
}

}  // namespace

TEST_CASE("in domain: an enclosure is cut at 0 and 1 and holds its parameter still", "[trace]") {
  check({quarter, 3 * quarter}, quarter, 3 * quarter);
  check({-quarter, quarter}, 0, quarter);
  check({quarter, 1 + quarter}, quarter, 1);
  check({-1, 2}, 0, 1);
  check({0, 1}, 0, 1);
  // Of a parameter 0 or 1 the enclosure may lie outside but for that point.
  check({-quarter, 0}, 0, 0);
  check({1, 1 + quarter}, 1, 1);
}

}  // namespace exsect::in_domain_test
