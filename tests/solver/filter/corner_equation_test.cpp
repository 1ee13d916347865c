#include "filter/corner_equation.h"

#include "support/catch.h"
#include "support/power_nets.h"
#include "support/random_nets.h"

namespace exsect::corner_equation_test {
namespace {

using filter::CornerSplit;
using filter::CornerSystem;
using filter::PlaneSeries;
using filter::WeightedBicubic;
using testing::power_patch;
using testing::Terms;

filter::CornerNet net_of(const RationalPatch& patch) {
  return filter::corner_net<WeightedBicubic>(filter::elevated<WeightedBicubic>(patch), 0, std::nullopt);
}

const Terms kNone, kMinus = {{{0, 0}, -1}}, kU = {{{1, 0}, 1}}, kV = {{{0, 1}, 1}};

/// The sum of the polynomial at (p,q).
Rational value(const PlaneSeries& f, const Rational& p, const Rational& q) {
  Rational sum = 0, first = 1;
  for (int i = 0; i <= f.order(); ++i, first *= p) {
    Rational second = first;
    for (int j = 0; i + j <= f.order(); ++j, second *= q) sum += f.coefficient(i, j) * second;
  }
  return sum;
}

CornerSplit split_with(const CornerSystem& system, const std::array<std::size_t, 2>& bound) {
  for (const CornerSplit& split : system.splits())
    if (split.bound == bound) return split;
  FAIL("no such split");
  return {};
}

}  // namespace

TEST_CASE("corner equation: an inverse function, by Catalan's numbers", "[filter]") {
  // r - r^2 = u, s = v: r = u + u^2 + 2 u^3 + 5 u^4 + ...; the height is u^3 - v^2.
  const RationalPatch x = power_patch({kU, kV, kU * kU * kU + kMinus * kV * kV}, 3);
  const RationalPatch y = power_patch({kU + kMinus * kU * kU, kV, kNone}, 3);
  const CornerSystem system(net_of(x), net_of(y));
  CHECK(system.splits().size() == 4);  // of six, u with r and v with s are parallel
  const CornerSplit split = split_with(system, {2, 3});
  const auto series = system.series(split, 4);
  const std::array<int, 5> catalan = {0, 1, 1, 2, 5};
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; i + j <= 4; ++j) {
      CHECK(series[0].coefficient(i, j) == (j == 0 ? catalan[static_cast<std::size_t>(i)] : 0));
      CHECK(series[1].coefficient(i, j) == (i == 0 && j == 1 ? 1 : 0));
    }
  const auto equation = system.equation(split, series, Rational(1, 16));
  REQUIRE(equation);
  const Rational cube = equation->normal.coefficient(3, 0), square = equation->normal.coefficient(0, 2);
  CHECK(cube != 0);
  CHECK(square == -cube);
  CHECK(equation->normal.coefficient(1, 1) == 0);
  // The next one is 14.
  CHECK(equation->bound[0].rest() >= 14);
  CHECK_FALSE(system.equation(split, series, Rational(1, 4)));  // where 2 r may be 1
}

TEST_CASE("corner equation: none of patches that cross, or have one direction in common", "[filter]") {
  const RationalPatch plane = power_patch({kU, kV, kNone}, 1);
  CHECK(CornerSystem(net_of(plane), net_of(power_patch({kU, kNone, kV}, 1))).splits().empty());
  const RationalPatch ridge = power_patch({kU, kV * kV, kNone}, 2);
  CHECK(CornerSystem(net_of(ridge), net_of(power_patch({kU, kNone, kV * kV}, 2))).splits().empty());
  CHECK(CornerSystem(net_of(ridge), net_of(plane)).splits().size() == 2);
}

TEST_CASE("corner equation: values of random patches with weights at solutions of the bound rows",
          "[filter]") {
  int proved = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    INFO("seed " << seed);
    random_nets::Generator generator(seed);
    random_nets::Net first = random_nets::tiny(generator, 2, 2), second = random_nets::tiny(generator, 2, 2);
    first[0][0] = second[0][0] = {0, 0, 0};
    first[1][0][2] = first[0][1][2] = second[1][0][2] = second[0][1][2] = 0;
    try {
      const RationalPatch x = random_nets::weighted_by_one_or_two(generator, first);
      const RationalPatch y = random_nets::weighted_by_one_or_two(generator, second);
      const CornerSystem system(net_of(x), net_of(y));
      for (const CornerSplit& split : system.splits()) {
        const Rational reach(1, 128);
        const auto equation = system.equation(split, system.series(split, 4), reach);
        if (!equation) continue;
        ++proved;
        // The plane of the derivatives is z = 0: to within the rest x and y agree in it at these values, and
        // the normal row is the difference of heights times weights and a constant.
        int same = 0, opposite = 0;
        for (const int k : {1, 2, 3, 5}) {
          std::array<Rational, 4> at;
          at[split.free[0]] = Rational(k, 3000), at[split.free[1]] = Rational(1, 500 * k);
          for (std::size_t i = 0; i < 2; ++i)
            at[split.bound[i]] = value(equation->bound[i], at[split.free[0]], at[split.free[1]]);
          const Point a = x(at[0], at[1]), b = y(at[2], at[3]);
          for (std::size_t c = 0; c < 2; ++c) CHECK(abs(Rational(a[c] - b[c])) < Rational(1, 1000000));
          const Rational height = a[2] - b[2];
          const Rational normal = value(equation->normal, at[split.free[0]], at[split.free[1]]);
          if (abs(height) < Rational(1, 10000000)) continue;
          ++(sign(normal) == sign(height) ? same : opposite);
        }
        CHECK(std::min(same, opposite) == 0);
      }
    } catch (const PatchError&) {  // no patch
    }
  }
  CHECK(proved >= 20);
}

}  // namespace exsect::corner_equation_test
