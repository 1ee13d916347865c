#include "filter/kind.h"

#include <limits>

#include "support/catch.h"

namespace exsect::kind_test {
namespace {

using namespace filter;  // NOLINT(google-build-using-namespace): vectors and their operations

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class K>
void check_counts(std::size_t side, std::size_t unknowns) {
  CHECK(K::side == side);
  CHECK(K::count == side * side);
  CHECK(K::unknowns == unknowns);
  CHECK(K::orders == 2 * side - 1);
  CHECK(kFirst<K> == side);
}

}  // namespace

TEST_CASE("kinds: counts of control points, unknowns and orders", "[filter]") {
  check_counts<Biquadratic>(3, 4);
  check_counts<Bicubic>(4, 4);
  check_counts<WeightedBiquadratic>(3, 5);
  check_counts<WeightedBicubic>(4, 5);
}

TEST_CASE("kinds: operations on vectors of three and of four numbers", "[filter]") {
  const Vec3 a = {1, -2, 4}, b = {0.5, 8, -1};
  CHECK(a + b == Vec3{1.5, 6, 3});
  CHECK(a - b == Vec3{0.5, -10, 5});
  CHECK(2.0 * a == Vec3{2, -4, 8});
  CHECK(filter::dot(a, b) == 0.5 - 16 - 4);
  CHECK(filter::cross(a, b) == Vec3{2 - 32, 2 + 1, 8 + 1});
  CHECK(size1(a) == 7);
  const Vec4 c = {1, -2, 4, -8}, d = {2, 2, 2, 2};
  CHECK(c + d == Vec4{3, 0, 6, -6});
  CHECK(c - d == Vec4{-1, -4, 2, -10});
  CHECK(-1.0 * c == Vec4{-1, 2, -4, 8});
  CHECK(filter::dot(c, d) == -10);
  CHECK(size1(c) == 15);
  CHECK(affine(c) == Vec3{-0.125, 0.25, -0.5});
  CHECK(affine(a) == a);
}

TEST_CASE("kinds: the largest entry, where no number is larger than all numbers", "[filter]") {
  CHECK(largest(Vec3{1, -2, 0.5}) == 2);
  CHECK(largest(Vec4{0, -0.0, 0, -3}) == 3);
  CHECK(largest(Vec3{0, -0.0, 0}) == 0);
  CHECK(largest(Vec3{1, -kInfinity, 2}) == kInfinity);
  for (std::size_t j = 0; j < 4; ++j)
    for (const double no_number : {kNan, -kNan}) {
      Vec4 a = {1, kInfinity, -2, 3};
      a[j] = no_number;
      // A bound of it holds no more: every comparison with it fails.
      CHECK_FALSE(largest(a) <= std::numeric_limits<double>::max());
      CHECK_FALSE(largest(a) <= kInfinity);
    }
}

}  // namespace exsect::kind_test
