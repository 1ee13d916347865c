#include "filter/common_normal.h"

#include <cmath>

#include "support/catch.h"
#include "support/graph_patches.h"
#include "support/random_pairs.h"

namespace exsect::common_normal_test {
namespace {

using namespace filter;
using testing::Terms;

/// e + a (u - 1/3)^2 + b (v - 2/3)^2 over a plane.
Pair height(const Rational& e, long a, long b) {
  const Terms p = {{{1, 0}, 1}, {{0, 0}, Rational(-1, 3)}};
  const Terms q = {{{0, 1}, 1}, {{0, 0}, Rational(-2, 3)}};
  const Terms h = Terms{{{0, 0}, e}} + Terms{{{0, 0}, a}} * p * p + Terms{{{0, 0}, b}} * q * q;
  return make_pair(testing::graph(h), testing::plane_patch()).value();
}

}  // namespace

TEST_CASE("common normals: where the height over a plane is stationary", "[filter]") {
  for (const double e : {0.0, 1e-9, 1e-3, -0.1}) {
    const Pair pair = height(from_double(e), 2, 3);
    const auto found = common_normal(pair, Vec4{-0.1, 0.1, -0.2, 0.2});
    REQUIRE(found);
    for (const std::size_t j : {0U, 2U}) CHECK(found->at[j] == Approx(1.0 / 3 - 0.5).margin(1e-12));
    for (const std::size_t j : {1U, 3U}) CHECK(found->at[j] == Approx(2.0 / 3 - 0.5).margin(1e-12));
    // In scaled space.
    CHECK(found->distance * std::exp2(pair.frame.exponent) == Approx(std::fabs(e)).margin(1e-14));
  }
}

TEST_CASE("common normals: crossings by the signs of the heights' form", "[filter]") {
  const Vec4 at = {1.0 / 3 - 0.5, 2.0 / 3 - 0.5, 1.0 / 3 - 0.5, 2.0 / 3 - 0.5};
  CHECK(looks_like_crossing(height(0, 2, -3), at));
  CHECK(looks_like_crossing(height(0, -1, 1), at));
  CHECK_FALSE(looks_like_crossing(height(0, 2, 3), at));
  CHECK_FALSE(looks_like_crossing(height(0, -2, -1), at));
}

TEST_CASE("common normals: Taylor coefficients by differences", "[filter]") {
  random_pairs::Generator generator(20278);
  const auto p = random_pairs::doubles(generator);
  const Pair pair = make_pair(p.x, p.y).value();
  const double h = 0.125, k = -0.25, d = 0x1p-12;
  const auto value = [&](double a, double b) { return second_order(pair.x, a, b).value; };
  const SecondOrder at = second_order(pair.x, h, k);
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(at.u[c] == Approx((value(h + d, k)[c] - value(h - d, k)[c]) / (2 * d)).margin(1e-9));
    CHECK(at.v[c] == Approx((value(h, k + d)[c] - value(h, k - d)[c]) / (2 * d)).margin(1e-9));
    CHECK(at.uu[c] ==
          Approx((value(h + d, k)[c] - 2 * at.value[c] + value(h - d, k)[c]) / (2 * d * d)).margin(1e-7));
    CHECK(at.vv[c] ==
          Approx((value(h, k + d)[c] - 2 * at.value[c] + value(h, k - d)[c]) / (2 * d * d)).margin(1e-7));
    const double mixed =
        value(h + d, k + d)[c] - value(h + d, k - d)[c] - value(h - d, k + d)[c] + value(h - d, k - d)[c];
    CHECK(at.uv[c] == Approx(mixed / (4 * d * d)).margin(1e-7));
  }
}

}  // namespace exsect::common_normal_test
