// Where poles lie on other patches: rational, irrational, near and not on them.
#include "special/pole_on_patch.h"

#include "support/catch.h"

namespace exsect::pole_on_patch_test {
namespace {

RationalPatch cone(const Point& apex) { return RationalPatch({{apex, apex}, {{0, 0, 5}, {1, 0, 5}}}); }

/// (r, s, r^2 + s^2), which is at (c,d,c^2 + d^2) for r = c, s = d alone.
RationalPatch paraboloid() {
  const Rational h(1, 2);
  return RationalPatch({{{0, 0, 0}, {0, h, 0}, {0, 1, 1}},
                        {{h, 0, 0}, {h, h, 0}, {h, 1, 1}},
                        {{1, 0, 1}, {1, h, 1}, {1, 1, 2}}});
}

/// (r^2 + r, s, s^3 + r): its parameters are roots for rational points.
RationalPatch curved() {
  const Rational h(1, 2), third(1, 3);
  std::vector<std::vector<Point>> net;
  for (long i = 0; i < 3; ++i) {
    net.emplace_back();
    for (long j = 0; j < 4; ++j) {
      const Rational x = i == 0 ? Rational(0) : i == 1 ? h : Rational(2);
      net.back().push_back({x, third * j, Rational(j == 3 ? 1 : 0) + h * i});
    }
  }
  return RationalPatch(net);
}

}  // namespace

TEST_CASE("pole_on_patch: a rational place") {
  const auto found =
      pole_on_patch(cone({Rational(2, 7), Rational(3, 5), Rational(4, 49) + Rational(9, 25)}), paraboloid());
  REQUIRE(found);
  CHECK(found->is_rational());
  CHECK(found->at[0].lower == Rational(2, 7));
  CHECK(found->at[1].upper == Rational(3, 5));
}

TEST_CASE("pole_on_patch: an irrational place is enclosed") {
  // r^2 + r = 1: r = (sqrt 5 - 1)/2. The third coordinate would be irrational; turned into a sum it is not.
  const RationalPatch patch = curved();
  CHECK(!pole_on_patch(cone({1, Rational(1, 2), Rational(618, 1000) + Rational(1, 8)}), patch));
  std::vector<std::vector<Point>> net;
  for (int i = 0; i < 3; ++i) {
    net.emplace_back();
    for (int j = 0; j < 4; ++j) {
      const Point p = patch.point(i, j);
      net.back().push_back({p[0], p[1], p[0] + p[1]});
    }
  }
  const auto found = pole_on_patch(cone({1, Rational(1, 2), Rational(3, 2)}), RationalPatch(net));
  REQUIRE(found);
  CHECK(!found->is_rational());
  const Rational low = found->at[0].lower, high = found->at[0].upper;
  CHECK(low * low + low < 1);
  CHECK(high * high + high > 1);
  CHECK(high - low <= power_of_two(-80));
}

TEST_CASE("pole_on_patch: nothing where there is no pole, or it is not on the patch, however near") {
  const Point on = {Rational(2, 7), Rational(3, 5), Rational(4, 49) + Rational(9, 25)};
  CHECK(!pole_on_patch(RationalPatch({{on, {1, 1, 1}}, {{0, 0, 5}, {1, 0, 5}}}), paraboloid()));
  CHECK(!pole_on_patch(cone({2, 2, 8}), paraboloid()));
  for (const long bits : {10, 30, 60, 100, 300})
    CHECK(!pole_on_patch(cone({on[0], on[1], on[2] + power_of_two(-bits)}), paraboloid()));
}

}  // namespace exsect::pole_on_patch_test
