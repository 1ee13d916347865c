// Parts and points inside, outside and on the boundary of a box.
#include "filter/known_box.h"

#include <cmath>
#include <limits>

#include "support/catch.h"

namespace exsect::known_box_test {
namespace {

constexpr double lower = 0.25, upper = 0.25 + 0x1p-12;

filter::KnownBox box() {
  const RationalInterval range = {from_double(lower), from_double(upper)};
  return filter::known_box({range, range, range, range});
}

filter::Part part(double from, double to) {
  filter::Part result{};
  result.range[0] = result.range[1] = {from, to};
  return result;
}

std::optional<bool> is_in(double first, double others, double radius) {
  const std::array<double, 4> middle = {first - 0.5, others - 0.5, others - 0.5, others - 0.5};
  return filter::is_in(box(), middle, radius);
}

}  // namespace

TEST_CASE("known box: parts lie in it up to its ends, exactly") {
  const filter::Part all = part(lower, upper);
  CHECK(filter::lie_in(box(), all, all));
  CHECK(filter::lie_in(box(), part(lower, lower), part(upper, upper)));
  for (const filter::Part& beyond :
       {part(std::nextafter(lower, 0), upper), part(lower, std::nextafter(upper, 1)),
        part(std::nan(""), upper), part(lower, std::nan(""))}) {
    CHECK_FALSE(filter::lie_in(box(), beyond, all));
    CHECK_FALSE(filter::lie_in(box(), all, beyond));
  }
}

TEST_CASE("known box: points are inside, outside, or not decided") {
  const double middle = 0.5 * (lower + upper), nan = std::nan("");
  CHECK(is_in(middle, middle, 0x1p-20) == std::optional(true));
  CHECK(is_in(middle, middle, 0x1p-13) == std::nullopt);
  CHECK(is_in(lower, middle, 0) == std::nullopt);
  CHECK(is_in(upper, middle, 0) == std::nullopt);
  CHECK(is_in(lower - 0x1p-40, middle, 0x1p-50) == std::optional(false));
  CHECK(is_in(upper + 0x1p-40, middle, 0x1p-50) == std::optional(false));
  CHECK(is_in(upper + 0x1p-40, middle, 0x1p-30) == std::nullopt);
  // One parameter outside is enough, whatever the others are.
  CHECK(is_in(0.75, lower, 0) == std::optional(false));
  CHECK(is_in(nan, middle, 0) == std::nullopt);
  CHECK(is_in(middle, middle, nan) == std::nullopt);
  CHECK(is_in(middle, middle, std::numeric_limits<double>::infinity()) == std::nullopt);
}

}  // namespace exsect::known_box_test
