// Bounds of patches in doubles against exact values.
#include "verify/patch_in_doubles.h"

#include <exsect/geometry/rational_patch.h>

#include <cmath>
#include <limits>

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::patch_in_doubles_test {
namespace {

using random_nets::Generator;

double distance(const Point& a, const Point& b) {
  const Point d = a - b;
  return std::sqrt(to_double(dot(d, d)));
}

Point exactly(const SpacePoint& p) { return {from_double(p[0]), from_double(p[1]), from_double(p[2])}; }

/// Parameters in [-margin, 1 + margin], with 53 bits.
std::array<double, 2> place(Generator& generator, double margin) {
  const auto one = [&] {
    const double unit = static_cast<double>(generator() >> 11U) * 0x1p-53;
    return -margin + unit * (1 + 2 * margin);
  };
  return {one(), one()};
}

/// What is promised, at random places; the largest speeds that are met.
std::array<double, 2> check_bounds(const RationalPatch& patch, const PatchInDoubles& x, Generator& generator,
                                   double margin) {
  std::array<double, 2> met = {0, 0};
  const auto value = [&](const std::array<double, 2>& p) {
    return patch(from_double(p[0]), from_double(p[1]));
  };
  for (int i = 0; i < 40; ++i) {
    const auto p = place(generator, margin);
    const auto q = place(generator, margin);
    CHECK(distance(exactly(x(p[0], p[1])), value(p)) <= x.rounding());
    const std::array<double, 2> d = {std::fabs(p[0] - q[0]), std::fabs(p[1] - q[1])};
    CHECK(distance(value(p), value(q)) <= (x.speed(0) * d[0] + x.speed(1) * d[1]) * (1 + 1e-12));
    const std::array<double, 2> middle = {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2};
    const Point chord = Rational(1, 2) * (value(p) + value(q));
    CHECK(distance(value(middle), chord) <= x.second_derivative(p[0] - q[0], p[1] - q[1]) / 8 + 1e-14);
    for (const std::size_t k : {0U, 1U}) {
      auto next = p;
      next[k] += p[k] < 0.5 ? 0x1p-12 : -0x1p-12;
      met[k] = std::max(met[k], distance(value(p), value(next)) * 0x1p12);
    }
  }
  return met;
}

RationalPatch scaled(const RationalPatch& x, const Rational& space, const Rational& weights) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (int i = 0; i <= x.degree_u(); ++i) {
    net.emplace_back();
    for (int j = 0; j <= x.degree_v(); ++j) {
      HomogeneousPoint p = x.homogeneous(i, j);
      for (std::size_t k = 0; k < 4; ++k) p[k] *= k < 3 ? Rational(space * weights) : weights;
      net.back().push_back(p);
    }
  }
  return RationalPatch::from_homogeneous(net);
}

}  // namespace

TEST_CASE("patch in doubles: values and derivatives keep within their bounds") {
  const unsigned seed = 11;
  INFO("seed " << seed);
  Generator generator(seed);
  for (int m = 1; m <= 3; ++m) {
    for (int n = 1; n <= 3; ++n) {
      for (const bool weights : {false, true}) {
        for (const double margin : {1.0 / 64, weights ? 1.0 / 16 : 1.0}) {
          INFO(m << " " << n << (weights ? " weighted" : "") << ", margin " << margin);
          const auto nets = random_nets::crossing(generator, {m, n, m, n}, true);
          const RationalPatch patch = weights ? random_nets::weighted(generator, nets.x) : nets.first();
          const PatchInDoubles x(patch, from_double(margin));
          const auto met = check_bounds(patch, x, generator, margin);
          for (const std::size_t k : {0U, 1U}) CHECK(x.speed(k) <= (weights ? 30 : 12) * met[k]);
          CHECK(x.rounding() <= 1e-9);
        }
      }
    }
  }
}

TEST_CASE("patch in doubles: single weights below zero, and a denominator that vanishes beside the square") {
  const std::vector<std::vector<Point>> points = {{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}},
                                                  {{1, 0, 0}, {1, 1, 1}, {1, 2, 0}}};
  Generator generator(12);
  // 1 - 2 t + (some) t² along v, at least 3/8 on the square: the middle weight is -1/4
  const RationalPatch below(points, {{1, Rational(-1, 4), 1}, {1, Rational(-1, 4), 1}});
  const PatchInDoubles x(below, Rational(1, 64));
  REQUIRE(std::isfinite(x.rounding()));
  check_bounds(below, x, generator, 1.0 / 64);
  CHECK(x.certainly_farther({0, 0, 10}, 1));
  CHECK_FALSE(x.certainly_farther(x(0.3, 0.7), 1e-9));
  // 1 + v / (1/128) - like: zero at v = -1/127
  const RationalPatch beside(points,
                             {{Rational(1, 128), Rational(1, 2), 1}, {Rational(1, 128), Rational(1, 2), 1}});
  CHECK(std::isfinite(PatchInDoubles(beside, 0).rounding()));
  CHECK_FALSE(std::isfinite(PatchInDoubles(beside, Rational(1, 64)).rounding()));
  CHECK_FALSE(std::isfinite(PatchInDoubles(beside, Rational(1, 64)).speed(0)));
}

TEST_CASE("patch in doubles: what is certainly farther is farther") {
  const unsigned seed = 13;
  INFO("seed " << seed);
  Generator generator(seed);
  for (const bool weights : {false, true}) {
    const auto nets = random_nets::crossing(generator, {3, 3, 2, 2}, true);
    const RationalPatch patch = weights ? random_nets::weighted(generator, nets.x) : nets.first();
    const PatchInDoubles x(patch, Rational(1, 64));
    for (int i = 0; i < 50; ++i) {
      const auto p = place(generator, 0);
      const SpacePoint on = x(p[0], p[1]);
      const double off = std::ldexp(1, -static_cast<int>(i % 16));
      const SpacePoint q = {on[0], on[1], on[2] + off};
      CHECK_FALSE(x.certainly_farther(q, off));
      CHECK_FALSE(x.certainly_farther(on, 0));
      // nearly a graph over the plane: the distance is not much smaller
      CHECK(x.certainly_farther(q, off / 64));
    }
    CHECK_FALSE(x.certainly_farther({0, 0, 100}, std::numeric_limits<double>::quiet_NaN()));
    CHECK_FALSE(x.certainly_farther({0, 0, 100}, std::numeric_limits<double>::infinity()));
  }
}

TEST_CASE("patch in doubles: any size of space and of weights") {
  Generator generator(14);
  const auto nets = random_nets::crossing(generator, {3, 2, 2, 2}, true);
  const RationalPatch patch = random_nets::weighted(generator, nets.x);
  const PatchInDoubles unit(patch, Rational(1, 64));
  for (const long space : {-190L, 0L, 190L}) {
    for (const long weights : {-1000L, 0L, 1000L}) {
      const RationalPatch large = scaled(patch, power_of_two(space), power_of_two(weights));
      const PatchInDoubles x(large, Rational(1, 64));
      const auto e = static_cast<int>(space);
      CHECK(x(0.25, 0.625)[2] == std::ldexp(unit(0.25, 0.625)[2], e));
      CHECK(x.speed(0) == std::ldexp(unit.speed(0), e));
      CHECK(x.rounding() == std::ldexp(unit.rounding(), e));
      const SpacePoint on = x(0.25, 0.625);
      const SpacePoint off = {on[0], on[1], on[2] + std::ldexp(1, e)};
      CHECK(x.certainly_farther(off, std::ldexp(0x1p-7, e)));
      CHECK_FALSE(x.certainly_farther(off, std::ldexp(1, e)));
    }
  }
}

}  // namespace exsect::patch_in_doubles_test
