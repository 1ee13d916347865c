#include "filter/kind.h"

#include <limits>
#include <random>

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

/// Along the first row, by minors of three.
double determinant(const Vec4& x, const Vec4& a, const Vec4& p, const Vec4& q) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto without = [i](const Vec4& v) {
      Vec3 rest;
      for (std::size_t j = 0, k = 0; j < 4; ++j)
        if (j != i) rest[k++] = v[j];
      return rest;
    };
    const double minor = filter::dot(without(a), filter::cross(without(p), without(q)));
    sum += (i % 2 == 0 ? 1 : -1) * x[i] * minor;
  }
  return sum;
}

Vec4 random_vector(std::mt19937& generator) {  // of integers: products are exact
  std::uniform_int_distribution<int> any(-9, 9);
  Vec4 result;
  for (double& c : result) c = any(generator);
  return result;
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

TEST_CASE("kinds: joins are determinants", "[filter]") {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    INFO("seed " << seed);
    std::mt19937 generator(seed);
    const Vec4 x = random_vector(generator), a = random_vector(generator);
    const Vec4 p = random_vector(generator), q = random_vector(generator);
    CHECK(filter::dot(x, join(a, wedge(p, q))) == determinant(x, a, p, q));
    CHECK(filter::dot(a, join(a, wedge(p, q))) == 0);
    CHECK(join(p, wedge(p, q)) == Vec4{});
  }
}

TEST_CASE("kinds: outer products of unit vectors", "[filter]") {
  const Vec4 e0 = {1, 0, 0, 0}, e1 = {0, 1, 0, 0}, e2 = {0, 0, 1, 0}, e3 = {0, 0, 0, 1};
  CHECK(filter::dot(e0, join(e1, wedge(e2, e3))) == 1);
  CHECK(wedge(e0, e2) == Vec<6>{0, 1, 0, 0, 0, 0});
  CHECK(wedge(Vec3{1, 0, 0}, Vec3{0, 1, 0}) == Vec3{0, 0, 1});
}

}  // namespace exsect::kind_test
