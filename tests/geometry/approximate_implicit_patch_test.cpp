#include <exsect/geometry/approximate_implicit_patch.h>
#include <exsect/geometry/implicit_patch.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/random_shapes.h"
#include "support/catch.h"

namespace exsect::approximate_implicit_patch_test {
namespace {

BezierPatch bent(int bend) {
  ControlNet net;
  const int height[3][3] = {{0, 3, 1}, {2, -1, 4}, {1, 5, -2}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      net[i][j] = {Rational(static_cast<int>(i), 2) + Rational(height[j][i], 40),
                   Rational(static_cast<int>(j), 2) - Rational(height[i][j], 30),
                   Rational(height[i][j], bend)};
  return BezierPatch(net);
}

TEST_CASE("approximate equations: bad input") {
  const BezierPatch x = bent(10);
  CHECK_THROWS_AS(approximate_equation(x, 0, PatchFit::dokken), std::invalid_argument);
  CHECK_THROWS_AS(approximate_equation(x, 8, PatchFit::dokken), std::invalid_argument);
  CHECK_THROWS_AS(approximate_equation(x, 6, PatchFit::conics), std::invalid_argument);
  ControlNet net;
  for (auto& row : net) row.fill({1, 2, 3});
  CHECK_THROWS_AS(approximate_equation(BezierPatch(net), 4, PatchFit::dokken), std::domain_error);
}

TEST_CASE("a patch with an equation of the degree gets that equation") {
  ControlNet c;
  for (auto& row : c) row.fill({0, 0, 0});
  c[1][0] = {1, 0, 0};
  c[0][1] = {0, 1, 0};
  c[2][2] = {0, 0, 1};
  const BezierPatch x = BezierPatch::from_power_basis(c);
  for (const PatchFit method : {PatchFit::dokken, PatchFit::conics}) {
    const ApproximateEquation q = approximate_equation(x, 4, method);
    CHECK(q.bound == 0);
    CHECK(q.equation == implicit_equation(x));
  }
}

TEST_CASE("the values on the patch keep the proved bound, which is not far off") {
  const std::uint64_t seed = 20260110;
  INFO("seed " << seed);
  Random random(seed);
  for (const BezierPatch& x : {bent(10), bent(100000), random_patch(random), random_patch(random)}) {
    for (const PatchFit method : {PatchFit::dokken, PatchFit::conics}) {
      const ApproximateEquation q = approximate_equation(x, 4, method);
      CHECK(q.equation.degree() == 4);
      Rational largest = 0;
      for (int i = 0; i <= 12; ++i)
        for (int j = 0; j <= 12; ++j)
          largest = std::max<Rational>(largest, abs(q.equation(x(Rational(i, 12), Rational(j, 12)))));
      CHECK(largest <= q.bound);
      CHECK(q.bound < 4 * largest);
      if (method == PatchFit::dokken) CHECK(to_double(q.bound) <= 1.01 * q.singular_value);
    }
  }
}

TEST_CASE("the conic construction nearly vanishes on the six conics") {
  const BezierPatch x = bent(10);
  const ApproximateEquation q = approximate_equation(x, 4, PatchFit::conics);
  const Rational half(1, 2);
  const std::vector<std::array<Rational, 2>> points = {
      {0, Rational(1, 8)}, {half, Rational(3, 8)}, {1, half}, {Rational(5, 8), 0}, {Rational(7, 8), half}};
  for (const auto& [u, v] : points) CHECK(std::abs(to_double(q.equation(x(u, v)))) <= q.singular_value);
}

TEST_CASE("smaller pieces are approximated better") {
  double last = 1;
  for (const int parts : {1, 2, 4, 8}) {
    const BezierPatch x = bent(10).restricted_to(0, Rational(1, parts), 0, Rational(1, parts));
    const double bound = to_double(approximate_equation(x, 4, PatchFit::dokken).bound);
    CHECK(bound < last / 4);
    last = bound;
  }
}

}  // namespace
}  // namespace exsect::approximate_implicit_patch_test
